// Orbit, pan, zoom, selection and drags. Only handles edit: orbiting can never move a box.
#include "ui/viewport_mouse.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/session/actions.h"
#include "render/picking.h"
#include "ui/camera_mouse.h"
#include "ui/point_tools.h"
#include "ui/selection.h"
#include "ui/studio.h"

namespace archetype {
namespace {

// Clicking again on the same place takes the next box below the cursor; with Shift or Ctrl the front one is
// taken in or out.
void select_at(Studio& studio, const Scene& scene, const GizmoView& view, const MouseInput& mouse) {
  if (studio.ui.look) return;  // there is nothing to edit
  std::vector<std::size_t> parts;
  const PartTemplate* active = studio.history.current().active_template();
  if (active && studio.ui.view.mean_boxes)
    for (const Pick& pick : pick_boxes(scene, ray_through(view.camera, view.viewport, mouse.cursor)))
      if (pick.object < active->parts.size()) parts.push_back(pick.object);
  if (mouse.shift || mouse.ctrl) {
    if (!parts.empty()) toggle_selected(studio.ui, parts.front());
    return;
  }
  if (parts.empty()) return select_only(studio.ui, std::nullopt);
  const auto current = std::find(parts.begin(), parts.end(), studio.ui.part);
  const bool next = current != parts.end() && current + 1 != parts.end();
  select_only(studio.ui, next ? *(current + 1) : parts.front());
}

void begin(Studio& studio, const MouseInput& mouse) {
  ViewportState& state = studio.viewport;
  state.pane().flight.reset();
  state.pressed_at = mouse.cursor;
  state.last_cursor = mouse.cursor;
  const bool left = mouse.button == ImGuiMouseButton_Left;
  state.after_click = camera_action(studio.ui.navigation, mouse);
  if (state.current != 0 && state.after_click == MouseAction::orbit) state.after_click = MouseAction::pan;
  const bool for_camera = studio.ui.navigation == Navigation::maya && mouse.alt;
  std::vector<PlacedPart> held = selected_boxes(studio);
  if (left && !for_camera && state.handle && !held.empty()) {
    state.action = MouseAction::handle;
    state.drag = BoxDrag{*state.handle, *held_box(held), mouse.cursor};
    state.drag_parts = std::move(held);
    state.snap_planes = snap_planes(studio, state.drag_parts);
    state.drag_previewed = false;
    studio.ui.drag_axis.reset();
    return;
  }
  state.action = left ? MouseAction::click : state.after_click;
}

DragModifiers modifiers(const Studio& studio, const MouseInput& mouse) {
  return {.about_centre = mouse.alt, .steps = mouse.shift, .only_axis = studio.ui.drag_axis};
}

void end_drag(ViewportState& state) {
  state.action = MouseAction::none;
  state.drag.reset();
  state.snapped.reset();
  state.drag_previewed = false;
}

// What the drag makes of the box, snapped where that is wanted.
Box pulled_box(Studio& studio, const MouseInput& mouse, const GizmoView& view) {
  ViewportState& state = studio.viewport;
  const DragModifiers held = modifiers(studio, mouse);
  const Box box = dragged_box(*state.drag, view, mouse.cursor, held);
  state.snapped.reset();
  if (studio.ui.snapping == mouse.ctrl) return box;
  state.snapped = snapped(box, *state.drag, held, state.snap_planes, snap_reach(view, box.centre));
  return state.snapped->box;
}

void drag_handle(Studio& studio, const MouseInput& mouse, const GizmoView& view) {
  ViewportState& state = studio.viewport;
  // Esc and undo drop the preview; the part may go with it, or another one be selected.
  const bool there = still_selected(studio, state.drag_parts);
  const bool dropped = state.drag_previewed && !studio.history.has_preview();
  if (dropped || !there) {
    if (state.drag_previewed) studio.history.cancel_preview();
    end_drag(state);
    return;
  }
  const Box box = pulled_box(studio, mouse, view);
  const std::vector<PlacedPart> placed = carried(state.drag_parts, state.drag->start, box);
  if (mouse.released) {
    // A click on a handle, or a drag that came back to its start, is no edit.
    if (state.drag_previewed) studio.history.cancel_preview();
    if (state.drag_previewed) set_part_boxes(studio.history, placed);
    end_drag(state);
    return;
  }
  const bool moved = glm::length(mouse.cursor - state.pressed_at) > click_reach * view.scale;
  if (!moved && !state.drag_previewed) return;
  set_part_boxes(studio.history, placed, Stage::live);
  state.drag_previewed = true;
}

void hover(Studio& studio, const MouseInput& mouse, const Scene& scene, const GizmoView& view,
           const std::vector<HandleShape>& shapes) {
  ViewportState& state = studio.viewport;
  state.hovered.reset();
  state.handle.reset();
  if (!mouse.over) return;
  state.handle = find_handle(shapes, view, mouse.cursor);
  if (state.handle) return;
  const std::shared_ptr<const PartTemplate> shown = shown_template(studio);
  if (!shown || !studio.ui.view.mean_boxes) return;
  const auto picks = pick_boxes(scene, ray_through(view.camera, view.viewport, mouse.cursor));
  if (!picks.empty() && picks.front().object < shown->parts.size()) state.hovered = picks.front().object;
}

void move_pane(ViewportState& state, const MouseInput& mouse, const GizmoView& view) {
  move_camera(state.pane().camera, state.action, view,
              {.pressed = state.pressed_at, .from = state.last_cursor, .to = mouse.cursor});
  state.last_cursor = mouse.cursor;
}

}  // namespace

void follow_mouse(Studio& studio, const MouseInput& mouse, const Scene& scene, const GizmoView& view,
                  const std::vector<HandleShape>& shapes) {
  ViewportState& state = studio.viewport;
  if (mouse.over && mouse.wheel != 0) {
    state.pane().flight.reset();
    zoom(state.pane().camera, view.viewport, mouse.cursor, std::pow(zoom_per_notch, mouse.wheel));
  }
  if (studio.ui.transform) return follow_transform(studio, mouse, view);
  if (follow_point_tool(studio, mouse, view)) return;
  if (state.action == MouseAction::none) hover(studio, mouse, scene, view, shapes);
  if (mouse.pressed) begin(studio, mouse);
  if (state.action == MouseAction::none) return;
  if (!mouse.held && !mouse.released) {
    // Somebody else took the mouse: Esc was pressed, or the window lost it.
    if (state.drag_previewed) studio.history.cancel_preview();
    end_drag(state);
    return;
  }
  if (state.action == MouseAction::handle) {
    drag_handle(studio, mouse, view);
    return;
  }
  if (state.action == MouseAction::click) {
    if (glm::length(mouse.cursor - state.pressed_at) > click_reach * view.scale)
      state.action = state.after_click;
    else if (mouse.released)
      select_at(studio, scene, view, mouse);
  }
  move_pane(state, mouse, view);
  if (mouse.released) state.action = MouseAction::none;
}

}  // namespace archetype
