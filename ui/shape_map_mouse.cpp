#include "ui/shape_map_mouse.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "ui/shape_cell.h"
#include "ui/shape_map_view.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

constexpr float click_reach = 4;  // screen units at scale 1, as in the viewport
constexpr float dot_reach = 9;
constexpr double map_zoom_per_notch = 1.2;  // of the wheel

bool inside(const std::vector<ImVec2>& outline, ImVec2 p) {
  bool in = false;
  for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
    const ImVec2 a = outline[i];
    const ImVec2 b = outline[j];
    if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x) in = !in;
  }
  return in;
}

// The picture that is drawn last there, or else the nearest dot within reach.
std::optional<std::size_t> point_at(const Studio& studio, const MadeMap& made, const MapSpace& space,
                                    const std::vector<std::size_t>& pictured, float side, ImVec2 mouse) {
  const MapState& state = studio.ui.map;
  for (auto i = pictured.rbegin(); i != pictured.rend(); ++i) {
    const ImVec2 at = space.at(state, made.map.points[*i]);
    if (std::abs(at.x - mouse.x) <= side / 2 && std::abs(at.y - mouse.y) <= side / 2) return *i;
  }
  std::optional<std::size_t> best;
  float least = dot_reach * studio.fonts.scale;
  for (std::size_t i = 0; i < made.map.points.size(); ++i) {
    const ImVec2 at = space.at(state, made.map.points[i]);
    const float away = std::hypot(at.x - mouse.x, at.y - mouse.y);
    if (away > least) continue;
    least = away;
    best = i;
  }
  return best;
}

void tell(Studio& studio, const MadeMap& made, const MapPoint& point) {
  const ShapeRow* row = map_row(studio, point.shape);
  if (!row) return;
  studio.ui.selection.hovering = point.shape;
  ImGui::BeginTooltip();
  const float side = 120 * studio.fonts.scale;
  if (const std::uint32_t texture = studio.thumbnails.use(shown_thumbnail(studio, *row)))
    ImGui::Image(reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(texture)), {side, side});
  ImGui::TextUnformatted(row->name.c_str());
  muted_text(studio, made.table->templates[point.part_template].part_template.name +
                         (point.outlier ? ", outlier" : ""));
  if (row->fit) {
    char energy[48];
    std::snprintf(energy, sizeof energy, "energy %.3f", row->fit->energy.total());
    muted_text(studio, energy);
  }
  ImGui::EndTooltip();
}

void zoom_about(MapState& state, const MapSpace& space, ImVec2 mouse, double factor) {
  const double dx = mouse.x - (space.low.x + space.high.x) / 2;
  const double dy = mouse.y - (space.low.y + space.high.y) / 2;
  const double zoom = std::clamp(state.zoom * factor, 1e-6, 1e9);
  state.x += dx / state.zoom - dx / zoom;
  state.y -= dy / state.zoom - dy / zoom;
  state.zoom = zoom;
  state.whole = false;
}

void click(Studio& studio, std::optional<ShapeId> shape) {
  ExplorerSelection& selection = studio.ui.selection;
  if (ImGui::GetIO().KeyCtrl) {
    if (shape) toggle_selected(selection, *shape);
    return;
  }
  if (!shape) return select_only(selection, {});
  select_only(selection, {*shape});
  show_shape(studio, *shape);
  studio.ui.grid.scroll_to_shape = true;
}

bool is_drag(const Studio& studio, const std::vector<ImVec2>& outline) {
  return std::ranges::any_of(outline, [&](ImVec2 p) {
    return std::hypot(p.x - outline.front().x, p.y - outline.front().y) > click_reach * studio.fonts.scale;
  });
}

void finish(Studio& studio, const MadeMap& made, const MapSpace& space, std::optional<std::size_t> under) {
  MapState& state = studio.ui.map;
  if (is_drag(studio, state.outline)) {
    std::vector<ShapeId> shapes = shapes_inside(made.map, state, space);
    say(studio, Severity::note, plural(shapes.size(), "shape") + " inside");
    if (ImGui::GetIO().KeyCtrl)
      add_to_selection(studio.ui.selection, shapes);
    else
      select_only(studio.ui.selection, std::move(shapes));
  } else {
    click(studio, under ? std::optional(made.map.points[*under].shape) : std::nullopt);
  }
  state.outline.clear();
}

}  // namespace

std::vector<ShapeId> shapes_inside(const ShapeMap& map, const MapState& state, const MapSpace& space) {
  std::vector<ImVec2> outline = state.outline;
  if (outline.size() < 2) return {};
  if (state.tool == MapTool::rectangle) {
    const ImVec2 a = outline.front();
    const ImVec2 b = outline.back();
    outline = {a, {b.x, a.y}, b, {a.x, b.y}};
  }
  std::vector<ShapeId> shapes;
  for (const MapPoint& point : map.points)
    if (inside(outline, space.at(state, point))) shapes.push_back(point.shape);
  return shapes;
}

void follow_map_mouse(Studio& studio, const MadeMap& made, const MapSpace& space,
                      const std::vector<std::size_t>& pictured, float side) {
  MapState& state = studio.ui.map;
  const ImGuiIO& io = ImGui::GetIO();
  ImGui::SetCursorScreenPos(space.low);
  ImGui::InvisibleButton("##map", space.size(),
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle);
  mark_target(studio, "map");
  const bool hovered = ImGui::IsItemHovered();
  const bool active = ImGui::IsItemActive();
  if (hovered && io.MouseWheel != 0)
    zoom_about(state, space, io.MousePos, std::pow(map_zoom_per_notch, io.MouseWheel));
  const std::optional<std::size_t> under =
      hovered || active ? point_at(studio, made, space, pictured, side, io.MousePos) : std::nullopt;
  if (ImGui::IsItemActivated()) {
    state.panning = io.MouseDown[ImGuiMouseButton_Middle] || io.KeyShift;
    state.outline.clear();
    if (!state.panning) state.outline.push_back(io.MousePos);
  }
  if (active && state.panning) {
    state.whole = state.whole && io.MouseDelta.x == 0 && io.MouseDelta.y == 0;
    state.x -= io.MouseDelta.x / state.zoom;
    state.y += io.MouseDelta.y / state.zoom;
  } else if (active && !state.outline.empty()) {
    const ImVec2 last = state.outline.back();
    const bool moved = last.x != io.MousePos.x || last.y != io.MousePos.y;
    if (moved && state.tool == MapTool::rectangle && state.outline.size() > 1)
      state.outline.back() = io.MousePos;
    else if (moved && state.outline.size() < 10'000)
      state.outline.push_back(io.MousePos);
  }
  if (ImGui::IsItemDeactivated() && !state.outline.empty()) finish(studio, made, space, under);
  if (!active) state.outline.clear();
  if (under && hovered && !active) tell(studio, made, made.map.points[*under]);
}

}  // namespace archetype
