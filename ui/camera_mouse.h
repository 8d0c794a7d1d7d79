// The mouse over an area that shows a scene, and how it moves the camera: the same in all views.
#pragma once

#include <imgui.h>

#include "ui/viewport.h"
#include "ui/viewport_mouse.h"

namespace archetype {

inline constexpr double click_reach = 4;  // pixels that a click may move, at scale 1
inline constexpr double zoom_per_notch = 0.87;

// Puts an invisible button over the area: Dear ImGui decides who has the mouse. What is drawn later may lie
// over it.
MouseInput read_mouse(int id, ImVec2 origin, ImVec2 size);

// What dragging with a button does where there is no handle. None: it only clicks.
MouseAction camera_action(Navigation navigation, const MouseInput& mouse);

// The way of the cursor since the last frame, and where the button went down.
struct CursorWay {
  glm::dvec2 pressed{0, 0};
  glm::dvec2 from{0, 0};
  glm::dvec2 to{0, 0};
};
// Orbits, pans or zooms; other actions move nothing.
void move_camera(Camera& camera, MouseAction action, const GizmoView& view, const CursorWay& way);

// For views in which nothing is edited.
struct CameraMouse {
  MouseAction action = MouseAction::none;
  MouseAction after_click = MouseAction::none;
  glm::dvec2 pressed_at{0, 0};
  glm::dvec2 last_cursor{0, 0};
};
// True in the frame in which a click with the left button ends that did not move.
bool follow_camera_mouse(CameraMouse& state, Navigation navigation, const MouseInput& mouse,
                         const GizmoView& view, Camera& camera);

}  // namespace archetype
