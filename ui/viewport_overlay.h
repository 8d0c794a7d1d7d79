// What is drawn over the picture of the viewport with Dear ImGui: handles, the names of parts, the axes.
#pragma once

#include <imgui.h>

#include <optional>
#include <vector>

#include "core/model/part_template.h"
#include "ui/gizmo.h"

namespace archetype {

// All of them draw into the clip rectangle of `draw`; `origin` is the upper left corner of the viewport
// there.
void draw_handles(ImDrawList& draw, ImVec2 origin, const std::vector<HandleShape>& shapes,
                  const std::optional<Handle>& highlighted, double scale);
// The edges of the box that the handles of several parts are about.
void draw_box_edges(ImDrawList& draw, ImVec2 origin, const Box& box, const GizmoView& view);
// A rectangle, screen units.
struct ScreenRect {
  ImVec2 low;
  ImVec2 high;
};
// Each name above its box, or below `taken` where it would lie over that; one that would lie over another's
// is left out, the selected part's never.
void draw_part_names(ImDrawList& draw, ImVec2 origin, const PartTemplate& part_template,
                     std::optional<std::size_t> selected, const GizmoView& view, const ScreenRect& taken);
// About a place that was pointed at, in whichever view.
void draw_place_ring(ImDrawList& draw, ImVec2 middle, float scale);
// The colour of an axis of the template, or of a box.
ImU32 axis_colour(int axis);
// In the lower left corner: where x, y and z point.
void draw_axes(ImDrawList& draw, ImVec2 origin, const GizmoView& view, ImU32 text_colour);

}  // namespace archetype
