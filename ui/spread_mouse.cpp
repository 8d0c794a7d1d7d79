#include "ui/spread_mouse.h"

#include <imgui.h>

#include <algorithm>
#include <cstdio>
#include <glm/geometric.hpp>
#include <utility>

#include "core/model/part_colours.h"
#include "core/session/actions.h"
#include "ui/selection.h"
#include "ui/studio.h"

namespace archetype {
namespace {

constexpr double click_reach = 3;  // pixels that a click may move, at scale 1

// The part whose dots are there: null if none.
const TemplatePart* part_with_dots(const Studio& studio) {
  const PartTemplate* active = studio.history.current().active_template();
  const bool there = active && studio.ui.part && *studio.ui.part < active->parts.size();
  if (!there || studio.ui.look || !studio.ui.view.spread || !studio.ui.view.mean_boxes) return nullptr;
  return &active->parts[*studio.ui.part];
}

void set_stddev(Studio& studio, const SpreadDrag& drag, const Vec3& stddev, Stage stage) {
  if (drag.handle.of == SpreadHandle::Of::position)
    set_position_stddev(studio.history, selected_parts(studio.ui), stddev, stage);
  else
    set_scale_stddev(studio.history, selected_parts(studio.ui), stddev, stage);
}

void drop(Studio& studio) {
  ViewportState& state = studio.viewport;
  if (std::exchange(state.spread_previewed, false)) studio.history.cancel_preview();
  state.spread_drag.reset();
  state.action = MouseAction::none;
}

void go_on(Studio& studio, const MouseInput& mouse, const GizmoView& view) {
  ViewportState& state = studio.viewport;
  // Esc and undo drop the preview; another part may be selected by a script.
  const bool dropped = state.spread_previewed && !studio.history.has_preview();
  const bool taken_away = !mouse.held && !mouse.released;
  const TemplatePart* part = part_with_dots(studio);
  if (dropped || taken_away || !part || part->name != state.spread_drag->start.name) return drop(studio);
  const SpreadDrag drag = *state.spread_drag;
  const Vec3 stddev = dragged_stddev(drag, view, mouse.cursor, mouse.shift);
  if (mouse.released) {
    const bool edited = state.spread_previewed;
    drop(studio);
    if (edited) set_stddev(studio, drag, stddev, Stage::done);
    return;
  }
  const bool moved = glm::length(mouse.cursor - drag.grabbed) > click_reach * view.scale;
  if (!moved && !state.spread_previewed) return;
  set_stddev(studio, drag, stddev, Stage::live);
  state.spread_previewed = true;
}

}  // namespace

bool follow_spread(Studio& studio, const MouseInput& mouse, const GizmoView& view) {
  ViewportState& state = studio.viewport;
  if (state.action == MouseAction::spread) {
    go_on(studio, mouse, view);
    return true;
  }
  state.spread_handle.reset();
  if (state.action != MouseAction::none || !mouse.over) return false;
  const TemplatePart* part = part_with_dots(studio);
  if (!part) return false;
  state.spread_handle = find_spread_handle(spread_dots(*part, view), view, mouse.cursor);
  if (!state.spread_handle || mouse.wheel != 0) return false;
  if (mouse.pressed && mouse.button != ImGuiMouseButton_Left) return false;
  state.handle.reset();
  state.hovered.reset();
  if (mouse.pressed) {
    state.action = MouseAction::spread;
    state.spread_drag = SpreadDrag{*state.spread_handle, *part, mouse.cursor};
  }
  return true;
}

void draw_spread_dots(const Studio& studio, ImDrawList& draw, ImVec2 origin, const GizmoView& view) {
  const TemplatePart* part = part_with_dots(studio);
  if (!part) return;
  const ViewportState& state = studio.viewport;
  const auto scale = static_cast<float>(view.scale);
  const Rgb rgb = part_colour(*studio.history.current().active_template(), static_cast<int>(*studio.ui.part));
  const auto held = state.spread_drag ? std::optional(state.spread_drag->handle) : state.spread_handle;
  for (const SpreadDot& dot : spread_dots(*part, view)) {
    const ImVec2 at(origin.x + static_cast<float>(dot.pixel.x), origin.y + static_cast<float>(dot.pixel.y));
    const bool highlighted = held == dot.handle;
    const float half = (highlighted ? 5.5F : 4.F) * scale;
    const ImVec2 corners[] = {
        {at.x, at.y - half}, {at.x + half, at.y}, {at.x, at.y + half}, {at.x - half, at.y}};
    draw.AddConvexPolyFilled(
        corners, 4, highlighted ? IM_COL32(255, 196, 46, 255) : IM_COL32(rgb[0], rgb[1], rgb[2], 255));
    draw.AddPolyline(corners, 4, IM_COL32(255, 255, 255, 235), ImDrawFlags_Closed, 1.3F * scale);
    if (!highlighted) continue;
    char text[48];
    std::snprintf(text, sizeof text, "%s \xc2\xb1 %c %.3f",
                  dot.handle.of == SpreadHandle::Of::position ? "centre" : "half size", 'x' + dot.handle.axis,
                  stddev_of(*part, dot.handle.of)[dot.handle.axis]);
    const ImVec2 size = ImGui::CalcTextSize(text);
    const float right = origin.x + static_cast<float>(view.viewport.width) - size.x - 9 * scale;
    const ImVec2 low(std::min(at.x + 12 * scale, right),
                     std::max(at.y - size.y - 8 * scale, origin.y + 4 * scale));
    draw.AddRectFilled({low.x - 5 * scale, low.y - 2 * scale},
                       {low.x + size.x + 5 * scale, low.y + size.y + 2 * scale}, IM_COL32(24, 26, 30, 235),
                       3 * scale);
    draw.AddText(low, IM_COL32(255, 255, 255, 255), text);
  }
}

}  // namespace archetype
