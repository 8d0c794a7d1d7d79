// Orbit, pan and zoom.
#include "ui/camera_mouse.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace archetype {
namespace {

constexpr double radians_per_pixel = 0.0085;  // at scale 1
constexpr double zoom_per_pixel = 0.994;      // upwards, at scale 1

}  // namespace

MouseInput read_mouse(int id, ImVec2 origin, ImVec2 size) {
  const ImGuiIO& io = ImGui::GetIO();
  constexpr ImGuiButtonFlags any_button = ImGuiButtonFlags_MouseButtonLeft |
                                          ImGuiButtonFlags_MouseButtonRight |
                                          ImGuiButtonFlags_MouseButtonMiddle;
  ImGui::SetCursorScreenPos(origin);
  ImGui::PushID(id);
  ImGui::InvisibleButton("##view", size, any_button);
  ImGui::SetItemAllowOverlap();
  ImGui::PopID();
  MouseInput mouse;
  mouse.cursor = {io.MousePos.x - origin.x, io.MousePos.y - origin.y};
  mouse.over = ImGui::IsItemHovered();
  mouse.held = ImGui::IsItemActive();
  mouse.pressed = ImGui::IsItemActivated();
  for (const int button : {ImGuiMouseButton_Left, ImGuiMouseButton_Right, ImGuiMouseButton_Middle})
    if (ImGui::IsMouseClicked(button)) mouse.button = button;
  // Also deactivated where Esc took the mouse away: only with all buttons up is it a release.
  mouse.released = ImGui::IsItemDeactivated() && !ImGui::IsAnyMouseDown();
  mouse.wheel = io.MouseWheel;
  mouse.shift = io.KeyShift;
  mouse.alt = io.KeyAlt;
  mouse.ctrl = io.KeyCtrl;
  return mouse;
}

MouseAction camera_action(Navigation navigation, const MouseInput& mouse) {
  const bool left = mouse.button == ImGuiMouseButton_Left;
  const bool right = mouse.button == ImGuiMouseButton_Right;
  switch (navigation) {
    case Navigation::archetype:
      if (right) return MouseAction::none;
      return left && !mouse.shift ? MouseAction::orbit : MouseAction::pan;
    case Navigation::blender:
      if (left || right) return MouseAction::none;
      return mouse.shift ? MouseAction::pan : mouse.ctrl ? MouseAction::zoom : MouseAction::orbit;
    case Navigation::maya:
      if (!mouse.alt) return MouseAction::none;
      return left ? MouseAction::orbit : right ? MouseAction::zoom : MouseAction::pan;
  }
  return MouseAction::none;
}

void move_camera(Camera& camera, MouseAction action, const GizmoView& view, const CursorWay& way) {
  const glm::dvec2 moved = way.to - way.from;
  if (action == MouseAction::orbit)
    orbit(camera, -moved.x * radians_per_pixel / view.scale, moved.y * radians_per_pixel / view.scale);
  if (action == MouseAction::pan) pan(camera, view.viewport, way.from, way.to);
  if (action == MouseAction::zoom)
    zoom(camera, view.viewport, way.pressed, std::pow(zoom_per_pixel, -moved.y / view.scale));
}

bool follow_camera_mouse(CameraMouse& state, Navigation navigation, const MouseInput& mouse,
                         const GizmoView& view, Camera& camera) {
  if (mouse.over && mouse.wheel != 0)
    zoom(camera, view.viewport, mouse.cursor, std::pow(zoom_per_notch, mouse.wheel));
  if (mouse.pressed) {
    state.pressed_at = state.last_cursor = mouse.cursor;
    state.after_click = camera_action(navigation, mouse);
    state.action = mouse.button == ImGuiMouseButton_Left ? MouseAction::click : state.after_click;
  }
  if (state.action == MouseAction::none) return false;
  if (!mouse.held && !mouse.released) {  // somebody else took the mouse
    state.action = MouseAction::none;
    return false;
  }
  bool clicked = false;
  if (state.action == MouseAction::click) {
    if (glm::length(mouse.cursor - state.pressed_at) > click_reach * view.scale)
      state.action = state.after_click;
    else
      clicked = mouse.released;
  }
  move_camera(camera, state.action, view,
              {.pressed = state.pressed_at, .from = state.last_cursor, .to = mouse.cursor});
  state.last_cursor = mouse.cursor;
  if (mouse.released) state.action = MouseAction::none;
  return clicked;
}

}  // namespace archetype
