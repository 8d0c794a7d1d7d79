#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

#include "core/report/plot.h"
#include "ui/shape_cell.h"
#include "ui/shape_map_paint.h"
#include "ui/shape_map_view.h"
#include "ui/studio.h"

namespace archetype {
namespace {

constexpr std::size_t most_pictured = 500;  // points in sight: with more of them, pictures would be scraps
constexpr std::size_t few = 2000;           // points that are drawn with smooth edges

void draw_dots(Studio& studio, const MadeMap& made, const MapSpace& space) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const MapState& state = studio.ui.map;
  const float scale = studio.fonts.scale;
  const bool many = made.map.points.size() > few;
  const float radius = (many ? 2.5f : 4.0f) * scale;
  const ImDrawListFlags flags = draw.Flags;
  if (many) draw.Flags &= ~ImDrawListFlags_AntiAliasedFill;
  const ImU32 lost = ImGui::GetColorU32(colours(studio).error);
  for (const MapPoint& point : made.map.points) {
    const ImVec2 at = space.at(state, point);
    if (!space.holds(at, radius)) continue;
    if (point.outlier) {
      const float arm = 1.2f * radius;
      draw.AddLine({at.x - arm, at.y - arm}, {at.x + arm, at.y + arm}, lost, 1.5f * scale);
      draw.AddLine({at.x - arm, at.y + arm}, {at.x + arm, at.y - arm}, lost, 1.5f * scale);
    } else {
      draw.AddCircleFilled(at, radius, map_colour(point.part_template, 0.85f), many ? 6 : 12);
    }
  }
  draw.Flags = flags;
}

void draw_pictures(Studio& studio, const MadeMap& made, const MapSpace& space,
                   const std::vector<std::size_t>& shown, float side) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const Palette& p = colours(studio);
  const float rounding = 5 * studio.fonts.scale;
  for (const std::size_t i : shown) {
    const MapPoint& point = made.map.points[i];
    const ShapeRow* row = map_row(studio, point.shape);
    if (!row) continue;
    const ImVec2 at = space.at(studio.ui.map, point);
    const ImVec2 low(at.x - side / 2, at.y - side / 2);
    const ImVec2 high(at.x + side / 2, at.y + side / 2);
    draw.AddRectFilled(low, high, ImGui::GetColorU32(p.raised), rounding);
    if (const std::uint32_t texture = studio.thumbnails.use(shown_thumbnail(studio, *row)))
      draw.AddImageRounded(reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(texture)), low, high,
                           {0, 0}, {1, 1}, IM_COL32_WHITE, rounding);
    const ImU32 edge = point.outlier ? ImGui::GetColorU32(p.error) : map_colour(point.part_template);
    draw.AddRect(low, high, edge, rounding, 0, 2 * studio.fonts.scale);
    studio.targets.push_back({"map:" + row->name, low.x, low.y, high.x, high.y});
  }
}

// Selected shapes, the one in view, the one under the mouse and the nearest to the wishes.
void draw_rings(Studio& studio, const MadeMap& made, const MapSpace& space,
                const std::vector<std::size_t>& shown, float side) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const Palette& p = colours(studio);
  const ExplorerSelection& selection = studio.ui.selection;
  const float scale = studio.fonts.scale;
  std::unordered_set<ShapeId> near;
  if (studio.ui.map.sliders)
    for (const NearShape& shape : studio.ui.map.slider.nearest) near.insert(shape.shape);
  const std::unordered_set<std::size_t> pictures(shown.begin(), shown.end());
  const auto ring = [&](std::size_t i, const ImVec4& colour, float grow, float width) {
    const ImVec2 at = space.at(studio.ui.map, made.map.points[i]);
    if (!space.holds(at, side)) return;
    if (pictures.contains(i)) {
      const float half = side / 2 + grow;
      draw.AddRect({at.x - half, at.y - half}, {at.x + half, at.y + half}, ImGui::GetColorU32(colour),
                   6 * scale, 0, width);
    } else {
      draw.AddCircle(at, 4 * scale + grow, ImGui::GetColorU32(colour), 0, width);
    }
  };
  for (std::size_t i = 0; i < made.map.points.size(); ++i) {
    const ShapeId shape = made.map.points[i].shape;
    if (near.contains(shape)) ring(i, p.good, 5 * scale, 2 * scale);
    if (is_selected(selection, shape)) ring(i, p.accent, 2 * scale, 2 * scale);
    if (studio.ui.shape == shape) ring(i, p.text, 3.5f * scale, 1.5f * scale);
    if (selection.hovered == shape) ring(i, p.warning, 2 * scale, 3 * scale);
  }
}

}  // namespace

ImU32 map_colour(std::size_t part_template, float opacity) {
  const Rgb colour = series_colour(part_template);
  return IM_COL32(colour[0], colour[1], colour[2], static_cast<int>(255 * opacity));
}

std::vector<std::size_t> pictured_points(const MapState& state, const ShapeMap& map, const MapSpace& space,
                                         float side) {
  std::size_t in_sight = 0;
  for (const MapPoint& point : map.points) in_sight += space.holds(space.at(state, point), 0);
  if (in_sight > most_pictured) return {};
  const double cell = 1.08 * side / state.zoom;
  std::unordered_map<std::int64_t, std::vector<std::size_t>> taken;
  const auto key = [](std::int64_t x, std::int64_t y) { return x * 4'000'037 + y; };
  std::vector<std::size_t> shown;
  for (std::size_t i = 0; i < map.points.size(); ++i) {
    const MapPoint& point = map.points[i];
    // Far outside of the view nothing can be in the way of what is inside.
    if (!space.holds(space.at(state, point), 6 * side)) continue;
    const auto cx = static_cast<std::int64_t>(std::floor(point.at[0] / cell));
    const auto cy = static_cast<std::int64_t>(std::floor(point.at[1] / cell));
    bool free = true;
    for (std::int64_t x = cx - 1; free && x <= cx + 1; ++x)
      for (std::int64_t y = cy - 1; free && y <= cy + 1; ++y)
        if (const auto there = taken.find(key(x, y)); there != taken.end())
          for (const std::size_t other : there->second)
            free = free && (std::abs(map.points[other].at[0] - point.at[0]) >= cell ||
                            std::abs(map.points[other].at[1] - point.at[1]) >= cell);
    if (!free) continue;
    taken[key(cx, cy)].push_back(i);
    if (space.holds(space.at(state, point), side / 2)) shown.push_back(i);
  }
  return shown;
}

void draw_map_points(Studio& studio, const MadeMap& made, const MapSpace& space,
                     const std::vector<std::size_t>& shown, float side) {
  draw_dots(studio, made, space);
  draw_pictures(studio, made, space, shown, side);
  draw_rings(studio, made, space, shown, side);
}

void draw_map_outline(Studio& studio) {
  const MapState& state = studio.ui.map;
  if (state.outline.size() < 2) return;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImVec4 accent = colours(studio).accent;
  const ImU32 colour = ImGui::GetColorU32(accent);
  const ImVec2 a = state.outline.front();
  const ImVec2 b = state.outline.back();
  if (state.tool == MapTool::rectangle) {
    draw.AddRectFilled({std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)},
                       ImGui::GetColorU32({accent.x, accent.y, accent.z, 0.12f}));
    draw.AddRect({std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}, colour);
  } else {
    draw.AddPolyline(state.outline.data(), static_cast<int>(state.outline.size()), colour, 0,
                     1.5f * studio.fonts.scale);
    draw.AddLine(b, a, ImGui::GetColorU32({accent.x, accent.y, accent.z, 0.5f}));
  }
}

}  // namespace archetype
