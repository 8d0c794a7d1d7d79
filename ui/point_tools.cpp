#include "ui/point_tools.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/geometry/box_points.h"
#include "core/learning/mirror_symmetry.h"
#include "core/session/actions.h"
#include "render/convert.h"
#include "ui/edit_overlay.h"
#include "ui/selection.h"
#include "ui/studio.h"
#include "ui/viewport_mouse.h"

namespace archetype {
namespace {

constexpr double least_drag = 5;          // pixels at scale 1; less is a click
constexpr double pick_reach = 16;         // pixels at scale 1 from the cursor to a sample
constexpr double same_box = 0.05;         // in units of its size
constexpr double least_thickness = 0.03;  // of a drawn box, half of it, normalised units
constexpr ImU32 chosen_colour = IM_COL32(255, 196, 46, 255);
constexpr ImU32 rim_colour = IM_COL32(20, 22, 26, 200);

int yaw_of(const Studio& studio) {
  return studio.shape.fit ? studio.shape.fit->fit.yaw_quarters : 0;
}

Vec3 to_scene(const Studio& studio, const Vec3& p) {
  return turn_quarters(p, -yaw_of(studio));
}

// A box of the shape's frame where the shape is seen, with axes that are called after the template's.
Box to_scene(const Studio& studio, const Box& box) {
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(-yaw_of(studio) * 0.5 * EIGEN_PI, Vec3::UnitY()));
  return with_nearest_axes({to_scene(studio, box.centre), box.half_extent, turn * box.orientation});
}

std::vector<glm::dvec2> rectangle(const glm::dvec2& a, const glm::dvec2& b) {
  return {a, {b.x, a.y}, b, {a.x, b.y}};
}

// The sample under the cursor: of those near it the one in front.
std::optional<std::size_t> sample_at(const std::vector<Vec3>& points, const GizmoView& view,
                                     const glm::dvec2& cursor) {
  std::optional<std::size_t> best;
  double least = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto pixel = to_screen(view.camera, view.viewport, to_glm(points[i]));
    if (!pixel || glm::length(*pixel - cursor) > pick_reach * view.scale) continue;
    const double depth = view_depth(view.camera, to_glm(points[i]));
    if (best && depth >= least) continue;
    best = i;
    least = depth;
  }
  return best;
}

bool inside(const glm::dvec2& p, const std::vector<glm::dvec2>& outline) {
  bool in = false;
  for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
    const glm::dvec2& a = outline[i];
    const glm::dvec2& b = outline[j];
    if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x) in = !in;
  }
  return in;
}

// Where there is no shape under the outline: in the plane of the screen through what the camera turns about.
Box box_in_air(const std::vector<glm::dvec2>& outline, const GizmoView& view) {
  std::vector<Vec3> places;
  const Vec3 back = to_eigen(back_axis(view.camera));
  const Vec3 target = to_eigen(view.camera.target);
  for (const glm::dvec2& pixel : outline) {
    const Ray ray = ray_through(view.camera, view.viewport, pixel);
    const Vec3 from = to_eigen(ray.origin);
    const Vec3 way = to_eigen(ray.direction);
    places.emplace_back(from + way * ((target - from).dot(back) / way.dot(back)));
  }
  return box_around(places, Eigen::Quaterniond::Identity());
}

void add_box(Studio& studio, Box box) {
  box.half_extent = box.half_extent.cwiseMax(least_thickness);
  select_only(studio.ui, add_part(studio.history, box));
  note_made_on_shape(studio);
}

// A region that has its box already is not given another one by a second click: it is selected.
void add_box_once(Studio& studio, const Box& box) {
  const std::vector<TemplatePart>& parts = studio.history.current().active_template()->parts;
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (box_distance(parts[i].mean_box(), box) < same_box * box.half_extent.norm())
      return select_only(studio.ui, i);
  add_box(studio, box);
}

void draw_box(Studio& studio, const std::vector<glm::dvec2>& outline, const GizmoView& view) {
  const std::vector<Vec3> points = points_in_view(studio);
  const std::vector<std::uint32_t> in = points_inside(points, outline, view);
  if (in.empty()) return add_box(studio, box_in_air(outline, view));
  const std::vector<Vec3> front = front_points(points, in, view, 3 * spacing_of(*studio.shape.samples));
  add_box(studio, box_around(front, Eigen::Quaterniond::Identity()));
}

// Shift adds to what is selected, Ctrl takes from it.
void select_points(Studio& studio, const MouseInput& mouse, const GizmoView& view) {
  PointToolState& state = studio.ui.points;
  const std::vector<std::uint32_t> in = points_inside(points_in_view(studio), state.outline, view);
  std::vector<std::uint32_t> before;
  if ((mouse.shift || mouse.ctrl) && state.shape_revision == studio.shape.shape_revision)
    before = state.selected;
  state.selected.clear();
  auto to = std::back_inserter(state.selected);
  if (mouse.ctrl)
    std::set_difference(before.begin(), before.end(), in.begin(), in.end(), to);
  else
    std::set_union(before.begin(), before.end(), in.begin(), in.end(), to);
  state.shape_revision = studio.shape.shape_revision;
  studio.ui.status = std::to_string(state.selected.size()) + " points selected";
}

void finish_outline(Studio& studio, const MouseInput& mouse, const GizmoView& view) {
  PointToolState& state = studio.ui.points;
  const glm::dvec2 way = state.outline.front() - state.outline[state.outline.size() / 2];
  const bool dragged = state.outline.size() > 2 && glm::length(way) > least_drag * view.scale;
  if (dragged && state.tool == PointTool::draw_box) draw_box(studio, state.outline, view);
  if (dragged && state.tool != PointTool::draw_box) select_points(studio, mouse, view);
  state.outline.clear();
  if (dragged) state.tool = PointTool::none;
}

void hover_region(Studio& studio, const MouseInput& mouse, const GizmoView& view) {
  PointToolState& state = studio.ui.points;
  state.hovered.reset();
  if (!mouse.over || !state.regions || state.regions->shape_revision != studio.shape.shape_revision) return;
  const auto sample = sample_at(points_in_view(studio), view, mouse.cursor);
  if (!sample || state.regions->of_sample[*sample] < 0) return;
  state.hovered = static_cast<std::size_t>(state.regions->of_sample[*sample]);
}

void ask_for_regions(Studio& studio) {
  PointToolState& state = studio.ui.points;
  if (by_outline(state.tool) || state.tool == PointTool::none || !studio.shape.samples) return;
  const RegionKind kind = state.tool == PointTool::segment ? RegionKind::segment : RegionKind::component;
  const std::uint64_t revision = studio.shape.shape_revision;
  if (studio.asked_regions == std::pair(kind, revision)) return;
  studio.asked_regions = {kind, revision};
  state.regions.reset();
  studio.region_worker.request({kind, studio.shape.mesh, studio.shape.samples, revision}, true);
}

}  // namespace

bool by_outline(PointTool tool) {
  return tool == PointTool::draw_box || tool == PointTool::rectangle || tool == PointTool::lasso;
}

void take_point_tool(Studio& studio, PointTool tool) {
  PointToolState& state = studio.ui.points;
  state.tool = state.tool == tool ? PointTool::none : tool;
  state.outline.clear();
  state.hovered.reset();
}

std::vector<Vec3> points_in_view(const Studio& studio) {
  std::vector<Vec3> points;
  if (!studio.shape.samples) return points;
  for (const Vec3& point : studio.shape.samples->points) points.push_back(to_scene(studio, point));
  return points;
}

std::vector<Vec3> selected_points(const Studio& studio) {
  const PointToolState& state = studio.ui.points;
  std::vector<Vec3> points;
  if (!studio.shape.samples || state.shape_revision != studio.shape.shape_revision) return points;
  for (const std::uint32_t i : state.selected)
    points.push_back(to_scene(studio, studio.shape.samples->points[i]));
  return points;
}

std::vector<std::uint32_t> points_inside(const std::vector<Vec3>& points,
                                         const std::vector<glm::dvec2>& outline, const GizmoView& view) {
  std::vector<std::uint32_t> in;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const auto pixel = to_screen(view.camera, view.viewport, to_glm(points[i]));
    if (pixel && inside(*pixel, outline)) in.push_back(i);
  }
  return in;
}

std::vector<Vec3> front_points(const std::vector<Vec3>& points, const std::vector<std::uint32_t>& indices,
                               const GizmoView& view, double gap) {
  std::vector<std::pair<double, std::uint32_t>> by_depth;
  by_depth.reserve(indices.size());
  for (const std::uint32_t i : indices) by_depth.emplace_back(view_depth(view.camera, to_glm(points[i])), i);
  std::sort(by_depth.begin(), by_depth.end());
  std::vector<Vec3> front;
  for (std::size_t i = 0; i < by_depth.size(); ++i) {
    if (i > 0 && by_depth[i].first - by_depth[i - 1].first > gap) break;
    front.push_back(points[by_depth[i].second]);
  }
  return front;
}

void note_made_on_shape(Studio& studio) {
  const PartTemplate* active = studio.history.current().active_template();
  if (!active || !studio.shape.samples) return;
  studio.ui.points.made_on = studio.shape.shape_revision;
  studio.ui.points.made_for = active->name;
}

bool stands_as_shown(const Studio& studio) {
  const PartTemplate* active = studio.history.current().active_template();
  return active && studio.ui.points.made_on == studio.shape.shape_revision &&
         studio.ui.points.made_for == active->name;
}

bool follow_point_tool(Studio& studio, const MouseInput& mouse, const GizmoView& view) {
  PointToolState& state = studio.ui.points;
  if (state.tool == PointTool::none) return false;
  if (studio.ui.look || !studio.history.current().active_template()) {
    state.tool = PointTool::none;
    return false;
  }
  ask_for_regions(studio);
  if (!by_outline(state.tool)) {
    // Clicks add; drags move the camera, as always.
    hover_region(studio, mouse, view);
    const bool clicked = mouse.released && studio.viewport.action == MouseAction::click;
    if (!clicked || !state.hovered) return false;
    studio.viewport.action = MouseAction::none;
    add_box_once(studio, to_scene(studio, state.regions->boxes[*state.hovered]));
    return true;
  }
  const bool free = studio.viewport.action == MouseAction::none;
  if (mouse.pressed && mouse.button == ImGuiMouseButton_Left && free) state.outline = {mouse.cursor};
  if (state.outline.empty()) return false;
  if (!mouse.held && !mouse.released) {
    state.outline.clear();  // somebody else took the mouse
    return true;
  }
  if (state.tool != PointTool::lasso)
    state.outline = rectangle(state.outline.front(), mouse.cursor);
  else if (glm::length(mouse.cursor - state.outline.back()) > 2)
    state.outline.push_back(mouse.cursor);
  if (mouse.released) finish_outline(studio, mouse, view);
  return true;
}

void draw_point_tool(Studio& studio, ImDrawList& draw, ImVec2 origin, const GizmoView& view,
                     const ScreenRect& taken) {
  const PointToolState& state = studio.ui.points;
  const auto scale = static_cast<float>(view.scale);
  const auto dot = [&](const Vec3& point) {
    const auto pixel = to_screen(view.camera, view.viewport, to_glm(point));
    if (!pixel) return;
    const ImVec2 at(origin.x + static_cast<float>(pixel->x), origin.y + static_cast<float>(pixel->y));
    draw.AddCircleFilled(at, 3.4F * scale, rim_colour, 8);
    draw.AddCircleFilled(at, 2.5F * scale, chosen_colour, 8);
  };
  for (const Vec3& point : selected_points(studio)) dot(point);
  if (state.tool == PointTool::none) return;
  if (state.hovered && state.regions) {
    const std::vector<Vec3> points = points_in_view(studio);
    for (std::size_t i = 0; i < points.size() && i < state.regions->of_sample.size(); ++i)
      if (state.regions->of_sample[i] == static_cast<int>(*state.hovered)) dot(points[i]);
  }
  std::vector<ImVec2> line;
  for (const glm::dvec2& p : state.outline)
    line.emplace_back(origin.x + static_cast<float>(p.x), origin.y + static_cast<float>(p.y));
  draw.AddPolyline(line.data(), static_cast<int>(line.size()), chosen_colour, ImDrawFlags_Closed,
                   1.6F * scale);
  const bool waits = !by_outline(state.tool) && !state.regions;
  const char* text = state.tool == PointTool::draw_box    ? "Drag over the part: its front becomes a box"
                     : state.tool == PointTool::rectangle ? "Drag a rectangle around points"
                     : state.tool == PointTool::lasso     ? "Draw a line around points"
                     : waits                              ? "Looking for the parts of the surface…"
                     : state.tool == PointTool::component ? "Click a connected piece: it gets a box"
                                                          : "Click a segment: it gets a box";
  draw_strip(draw, origin, view, taken, text,
             by_outline(state.tool) && state.tool != PointTool::draw_box
                 ? "Shift adds  ·  Ctrl takes away  ·  Esc ends"
                 : "Esc ends");
}

}  // namespace archetype
