// One frame of the viewport: takes over geometry, follows wishes and the mouse, draws what has changed.
#include "ui/viewport.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "ui/edit_overlay.h"
#include "ui/selection.h"
#include "ui/studio.h"
#include "ui/template_compare.h"
#include "ui/viewport_mouse.h"
#include "ui/viewport_overlay.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds flight_time{220};
constexpr std::chrono::milliseconds rest_before_fine_picture{180};
constexpr int fine = 2;  // supersampling of a picture that stands still

void take_over_shape(Studio& studio) {
  ViewportState& state = studio.viewport;
  const ShapeInView& shape = studio.shape;
  ShapeDisplayRequest request{shape.mesh, shape.samples, {}, shape.shape_revision};
  if (shape.record) request.frame = shape.record->frame;
  if (state.asked_display != shape.shape_revision) {
    state.asked_display = shape.shape_revision;
    state.coarse_worker.cancel();
    state.worker.request(request, true);
  }
  // The boxes of a shape do not belong over the one before it.
  if (!shape.record) state.display = {};
  if (auto made = state.worker.poll(); made && made->shape_revision == shape.shape_revision) {
    state.display = std::move(*made);
    if (state.display.mesh && state.display.mesh->triangle_count() > most_moving_triangles)
      state.coarse_worker.request(request, true);
  }
  if (const std::string problem = state.worker.take_problem(); !problem.empty()) {
    state.display = {};  // rather nothing than the shape before
    say(studio, Severity::error, "the shape cannot be drawn: " + problem);
  }
  if (auto made = state.coarse_worker.poll(); made && made->shape_revision == state.display.shape_revision)
    state.display.coarse = std::move(made->mesh);
  if (state.coloured_fit == shape.fit_revision && state.coloured_display == state.display.shape_revision)
    return;
  state.coloured_fit = shape.fit_revision;
  state.coloured_display = state.display.shape_revision;
  state.colours = shape.fit ? colours_of_fit(*shape.fit, state.display) : ShapeColours{};
}

bool moving(const ViewportState& state) {
  return state.flight || (state.action != MouseAction::none && state.action != MouseAction::click);
}

ViewportContent content_of(const Studio& studio) {
  const ViewportState& state = studio.viewport;
  ViewportContent content;
  content.part_template = shown_template(studio).get();
  if (!studio.ui.look) content.compared = compared_template(studio).get();
  content.fit = studio.shape.fit.get();
  content.display = state.display;
  content.colours = state.colours;
  content.view = studio.ui.view;
  if (!studio.ui.look) {
    content.selected = studio.ui.part;
    content.also_selected = studio.ui.also_selected;
  }
  content.hovered = state.hovered;
  content.moving = moving(state);
  content.backdrop = studio.theme == Theme::light ? Backdrop::light : Backdrop::dark;
  return content;
}

void fly(ViewportState& state, const Camera& to) {
  state.flight = CameraFlight{state.camera, to, Clock::now()};
}

ViewPreset preset_of(CameraView view) {
  switch (view) {
    case CameraView::front:
      return ViewPreset::front;
    case CameraView::back:
      return ViewPreset::back;
    case CameraView::left:
      return ViewPreset::left;
    case CameraView::right:
      return ViewPreset::right;
    case CameraView::top:
      return ViewPreset::top;
    case CameraView::bottom:
      return ViewPreset::bottom;
    case CameraView::home:
      return ViewPreset::three_quarter;
  }
  return ViewPreset::three_quarter;
}

void follow_wishes(Studio& studio, const ViewportContent& content, const Viewport& viewport) {
  ViewportState& state = studio.viewport;
  state.camera.orthographic = studio.ui.view.orthographic;
  const auto extent = extent_to_frame(content);
  if (!state.framed && extent && state.display.shape_revision != 0) {
    frame(state.camera, viewport, extent->first, extent->second);
    state.framed = true;
  }
  const auto wanted = std::exchange(studio.ui.wanted_view, std::nullopt);
  const bool frames = std::exchange(studio.ui.wanted_frame, false) || wanted == CameraView::home;
  if (wanted || frames) {
    Camera to = state.flight ? state.flight->to : state.camera;
    to.orthographic = state.camera.orthographic;
    if (wanted) look_from(to, preset_of(*wanted));
    ViewportContent all = content;
    if (wanted == CameraView::home) all.selected.reset();
    if (const auto room = extent_to_frame(all); frames && room)
      frame(to, viewport, room->first, room->second);
    fly(state, to);
  }
  if (!state.flight) return;
  const double t = std::chrono::duration<double>(Clock::now() - state.flight->start) / flight_time;
  const double eased = t >= 1 ? 1 : t * t * (3 - 2 * t);
  state.flight->to.orthographic = state.camera.orthographic;
  state.camera = blend(state.flight->from, state.flight->to, eased);
  state.camera.orthographic = studio.ui.view.orthographic;
  if (t >= 1) state.flight.reset();
}

// An invisible button over the whole view: Dear ImGui decides who has the mouse.
MouseInput read_mouse(Studio& studio, ImVec2 origin, ImVec2 size) {
  const ImGuiIO& io = ImGui::GetIO();
  constexpr ImGuiButtonFlags any_button = ImGuiButtonFlags_MouseButtonLeft |
                                          ImGuiButtonFlags_MouseButtonRight |
                                          ImGuiButtonFlags_MouseButtonMiddle;
  ImGui::InvisibleButton("##view", size, any_button);
  mark_target(studio, "viewport");
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

// Only when something has changed; once it has not for a while, in a finer picture.
void draw_picture(Studio& studio, const Scene& scene, ImVec2 size) {
  ViewportState& state = studio.viewport;
  const ImVec2 density = ImGui::GetIO().DisplayFramebufferScale;
  const float pixels = std::max(density.x, 1.F);
  PictureKey key;
  key.camera = state.camera;
  key.size = {static_cast<int>(std::lround(size.x * pixels)), static_cast<int>(std::lround(size.y * pixels)),
              1, pixels * studio.fonts.scale};
  key.view = studio.ui.view;
  key.backdrop = scene.backdrop;
  key.coarse = moving(state) && state.display.coarse;
  key.document_revision = studio.history.revision();
  if (studio.ui.look) key.looked_at = studio.ui.look->part_template;
  key.compared = compared_template(studio);
  key.fit_revision = state.coloured_fit;
  key.display_revision = state.display.shape_revision;
  key.selected = selected_parts(studio.ui);
  key.hovered = state.hovered;
  const bool changed = state.drawn != key;
  if (changed) state.changed_at = Clock::now();
  const bool rested = Clock::now() - state.changed_at > rest_before_fine_picture;
  const bool refine = !changed && !state.drawn_fine && rested && state.action == MouseAction::none;
  if (!changed && !refine) return;
  PictureSize drawn_size = key.size;
  if (refine) drawn_size.supersample = fine;
  state.renderer.draw(scene, state.camera, drawn_size, state.target);
  state.drawn = key;
  state.drawn_fine = refine;
}

void draw_overlay(Studio& studio, ImVec2 origin, ImVec2 size, const GizmoView& view,
                  const std::vector<HandleShape>& shapes) {
  const ViewportState& state = studio.viewport;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.PushClipRect(origin, {origin.x + size.x, origin.y + size.y}, true);
  const std::shared_ptr<const PartTemplate> shown = shown_template(studio);
  if (shown && studio.ui.view.mean_boxes && studio.ui.view.part_names)
    draw_part_names(draw, origin, *shown, studio.ui.part, view);
  const auto highlighted = state.drag ? std::optional(state.drag->handle) : state.handle;
  draw_handles(draw, origin, shapes, highlighted, view.scale);
  if (state.snapped) draw_snapped(draw, origin, *state.snapped, view);
  draw_transform(studio, draw, origin, view);
  draw_point_tool(studio, draw, origin, view);
  draw_axes(draw, origin, view, ImGui::GetColorU32(colours(studio).text));
  draw.PopClipRect();
}

std::vector<HandleShape> handles_of_selection(const Studio& studio, const GizmoView& view) {
  if (studio.ui.look || !studio.ui.view.mean_boxes || by_outline(studio.ui.points.tool)) return {};
  const std::optional<Box> held = held_box(selected_boxes(studio));
  return held ? handle_shapes(*held, studio.ui.tool, view) : std::vector<HandleShape>{};
}

}  // namespace

ViewportState::ViewportState(const std::filesystem::path& shaders, std::function<void()> wake)
    : renderer(shaders), worker(make_shape_display, wake), coarse_worker(make_coarse_mesh, std::move(wake)) {}

void draw_viewport(Studio& studio) {
  ViewportState& state = studio.viewport;
  take_over_shape(studio);
  draw_look_strip(studio);
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const ImVec2 size = ImGui::GetContentRegionAvail();
  if (size.x < 1 || size.y < 1) return;
  GizmoView view;
  view.viewport = {static_cast<int>(size.x), static_cast<int>(size.y)};
  view.scale = studio.fonts.scale;
  follow_wishes(studio, content_of(studio), view.viewport);
  view.camera = state.camera;

  const MouseInput mouse = read_mouse(studio, origin, size);
  follow_mouse(studio, mouse, make_viewport_scene(content_of(studio)), view,
               handles_of_selection(studio, view));
  view.camera = state.camera;

  draw_picture(studio, make_viewport_scene(content_of(studio)), size);
  // OpenGL's first row is the lowest.
  ImGui::GetWindowDrawList()->AddImage(
      reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(state.target.texture().name())), origin,
      {origin.x + size.x, origin.y + size.y}, {0, 1}, {1, 0});
  draw_overlay(studio, origin, size, view, handles_of_selection(studio, view));
}

bool viewport_busy(const ViewportState& state, std::uint64_t shape_revision) {
  return state.flight || !state.worker.idle() || state.asked_display != shape_revision ||
         (state.drawn && !state.drawn_fine && state.action == MouseAction::none);
}

}  // namespace archetype
