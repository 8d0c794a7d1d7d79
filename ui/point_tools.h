// Boxes from the shape: drawn on it, around points that were selected, around a region of its surface.
#pragma once

#include <imgui.h>

#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/vector.h"
#include "ui/gizmo.h"
#include "ui/surface_regions.h"

namespace archetype {

struct MouseInput;
struct ScreenRect;
struct Studio;

// What the left button does in the viewport where there is no handle. None: as always.
enum class PointTool { none, draw_box, rectangle, lasso, component, segment };

// Whether the tool draws with the mouse, and so has it before the handles of boxes.
bool by_outline(PointTool tool);

struct PointToolState {
  PointTool tool = PointTool::none;
  std::vector<glm::dvec2> outline;      // of the drag under way, pixels of the viewport
  std::vector<std::uint32_t> selected;  // samples of the shape, ascending
  std::uint64_t shape_revision = 0;     // that `selected` is of
  std::optional<std::size_t> hovered;   // the region under the cursor
  std::optional<SurfaceRegions> regions;
  // Of the shape that boxes were made on, and for which template.
  std::uint64_t made_on = 0;
  std::string made_for;
};

// Takes a tool, or lays it down where it is the one in hand. Components and segments begin to be found.
void take_point_tool(Studio& studio, PointTool tool);
// The selected points as they are drawn: turned with the shape by its fit. Empty where they are of another
// shape.
std::vector<Vec3> selected_points(const Studio& studio);
// All samples of the shape in view, likewise.
std::vector<Vec3> points_in_view(const Studio& studio);

// To be called where boxes are made of the points as they are shown: from then on the fit of this template
// leaves the shape in view as it stands.
void note_made_on_shape(Studio& studio);
bool stands_as_shown(const Studio& studio);

// Whether it took the mouse. Called before anything else that follows it.
bool follow_point_tool(Studio& studio, const MouseInput& mouse, const GizmoView& view);
// Outline, points and a line that says what to do.
void draw_point_tool(Studio& studio, ImDrawList& draw, ImVec2 origin, const GizmoView& view,
                     const ScreenRect& taken);

// The indices of the points inside of an outline on the screen.
std::vector<std::uint32_t> points_inside(const std::vector<Vec3>& points,
                                         const std::vector<glm::dvec2>& outline, const GizmoView& view);
// Of the points at the indices those of the front: until the first gap in depth that is wider than `gap`.
std::vector<Vec3> front_points(const std::vector<Vec3>& points, const std::vector<std::uint32_t>& indices,
                               const GizmoView& view, double gap);

}  // namespace archetype
