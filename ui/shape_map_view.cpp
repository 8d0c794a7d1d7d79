#include "ui/shape_map_view.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <unordered_set>

#include "core/report/plot.h"
#include "ui/icons.h"
#include "ui/plot_sources.h"
#include "ui/shape_map_mouse.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

constexpr std::size_t most_pictured = 500;  // points in sight: with more of them, pictures would be scraps
constexpr std::size_t few = 2000;           // points that are drawn with smooth edges

ImU32 template_colour(std::size_t part_template, float opacity = 1) {
  const Rgb colour = series_colour(part_template);
  return IM_COL32(colour[0], colour[1], colour[2], static_cast<int>(255 * opacity));
}

void fit_whole(MapState& state, const ShapeMap& map, const MapSpace& space) {
  float low[2] = {0, 0};
  float high[2] = {0, 0};
  for (const MapPoint& point : map.points) {
    for (int a = 0; a < 2; ++a) {
      low[a] = std::min(low[a], point.at[static_cast<std::size_t>(a)]);
      high[a] = std::max(high[a], point.at[static_cast<std::size_t>(a)]);
    }
  }
  state.x = (low[0] + high[0]) / 2;
  state.y = (low[1] + high[1]) / 2;
  const ImVec2 room = space.size();
  const float wide = std::max(high[0] - low[0], 1e-3f);
  const float tall = std::max(high[1] - low[1], 1e-3f);
  state.zoom = std::max(1e-6, 0.84 * std::min<double>(room.x / wide, room.y / tall));
}

// As many of the points as have room for a picture: those that stand first in the collection, wherever the
// view is moved to.
std::vector<std::size_t> pictured(const MapState& state, const ShapeMap& map, const MapSpace& space,
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
      draw.AddCircleFilled(at, radius, template_colour(point.part_template, 0.85f), many ? 6 : 12);
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
    if (const std::uint32_t texture = studio.thumbnails.use(wanted_thumbnail(*row)))
      draw.AddImageRounded(reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(texture)), low, high,
                           {0, 0}, {1, 1}, IM_COL32_WHITE, rounding);
    const ImU32 edge = point.outlier ? ImGui::GetColorU32(p.error) : template_colour(point.part_template);
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

std::string axis_text(const char* direction, const MapAxis& axis) {
  char share[32];
  std::snprintf(share, sizeof share, "  (%.0f %%)", 100 * axis.share);
  return std::string(direction) + axis.meaning + share;
}

// What the axes mean, and the templates with their colours; a click on one selects its shapes.
void draw_captions(Studio& studio, const MadeMap& made, const MapSpace& space) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const Palette& p = colours(studio);
  const float scale = studio.fonts.scale;
  const float line = ImGui::GetTextLineHeight();
  const float room = space.size().x - 24 * scale;
  const ImU32 muted = ImGui::GetColorU32(p.muted);
  if (made.map.axes[0].share > 0) {
    const std::string across = fitted(axis_text("Across: ", made.map.axes[0]), room);
    draw.AddText({space.low.x + 12 * scale, space.high.y - line - 8 * scale}, muted, across.c_str());
    if (made.map.axes[1].share > 0) {
      const std::string up = fitted(axis_text("Up: ", made.map.axes[1]), room);
      draw.AddText({space.low.x + 12 * scale, space.high.y - 2.2f * line - 8 * scale}, muted, up.c_str());
    }
  }
  std::vector<std::size_t> counts(made.table->templates.size());
  for (const MapPoint& point : made.map.points) ++counts[point.part_template];
  float y = space.low.y + 8 * scale;
  for (std::size_t t = 0; t < counts.size() && y + line < space.high.y - 3 * line; ++t) {
    if (counts[t] == 0) continue;
    const std::string text =
        fitted(made.table->templates[t].part_template.name, 0.35f * room) + "  " + count_text(counts[t]);
    ImGui::SetCursorScreenPos({space.low.x + 10 * scale, y});
    ImGui::PushID(static_cast<int>(t));
    const bool clicked =
        ImGui::InvisibleButton("legend", {ImGui::CalcTextSize(text.c_str()).x + 22 * scale, line});
    ImGui::PopID();
    mark_target(studio, "map:template:" + std::to_string(t));
    const bool hovered = ImGui::IsItemHovered();
    draw.AddCircleFilled({space.low.x + 16 * scale, y + line / 2}, 5 * scale, template_colour(t));
    draw.AddText({space.low.x + 28 * scale, y}, ImGui::GetColorU32(hovered ? p.accent : p.text),
                 text.c_str());
    tooltip("Select the shapes of this template");
    if (clicked) {
      std::vector<ShapeId> members;
      for (const MapPoint& point : made.map.points)
        if (point.part_template == t) members.push_back(point.shape);
      select_only(studio.ui.selection, std::move(members));
    }
    y += 1.35f * line;
  }
}

void draw_outline(Studio& studio) {
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

void draw_map(Studio& studio, const MadeMap& made, ImVec2 size) {
  MapState& state = studio.ui.map;
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const MapSpace space{low, {low.x + size.x, low.y + size.y}};
  if (studio.ui.wanted_frame || studio.ui.wanted_view) state.zoom = 0;
  studio.ui.wanted_frame = false;
  studio.ui.wanted_view.reset();
  if (!(state.zoom > 0)) fit_whole(state, made.map, space);
  const float side = std::clamp(size.y / 9, 44 * studio.fonts.scale, 84 * studio.fonts.scale);
  const std::vector<std::size_t> shown =
      state.pictures ? pictured(state, made.map, space, side) : std::vector<std::size_t>();
  ImGui::PushClipRect(space.low, space.high, true);
  draw_captions(studio, made, space);  // first: its buttons have the mouse before the map
  ImGui::SetCursorScreenPos(low);
  follow_map_mouse(studio, made, space, shown, side);
  draw_dots(studio, made, space);
  draw_pictures(studio, made, space, shown, side);
  draw_rings(studio, made, space, shown, side);
  draw_outline(studio);
  ImGui::PopClipRect();
}

void choose_map(Studio& studio, const FitTable& table) {
  MapState& state = studio.ui.map;
  std::string name = "All templates";
  for (const TemplateRecord& record : table.templates)
    if (record.id == state.of) name = record.part_template.name;
  const auto choose = [&](std::optional<TemplateId> of) {
    state.of = of;
    state.zoom = 0;
    if (of) studio.ui.selection.part = PartOfTemplate{*of, 0};
  };
  ImGui::SetNextItemWidth(190 * studio.fonts.scale);
  if (!ImGui::BeginCombo("##map-of", name.c_str())) {
    mark_target(studio, "map-of");
    tooltip("All templates: parts are compared by their labels.\nOne: its shapes only, by its own parts.");
    return;
  }
  if (ImGui::Selectable("All templates", !state.of)) choose(std::nullopt);
  mark_target(studio, "map-of:all");
  for (std::size_t t = 0; t < table.templates.size(); ++t) {
    ImGui::PushID(static_cast<int>(t));
    if (ImGui::Selectable(table.templates[t].part_template.name.c_str(), state.of == table.templates[t].id))
      choose(table.templates[t].id);
    mark_target(studio, "map-of:" + std::to_string(t));
    ImGui::PopID();
  }
  ImGui::EndCombo();
}

}  // namespace

const ShapeRow* map_row(Studio& studio, ShapeId shape) {
  MapState& state = studio.ui.map;
  const std::vector<ShapeRow>& rows = studio.collection.rows();
  if (state.rows_revision != studio.collection.revision || state.row_of.size() != rows.size()) {
    state.row_of.clear();
    for (std::size_t i = 0; i < rows.size(); ++i) state.row_of[rows[i].id] = i;
    state.rows_revision = studio.collection.revision;
  }
  const auto found = state.row_of.find(shape);
  return found == state.row_of.end() ? nullptr : &rows[found->second];
}

void draw_map_tools(Studio& studio) {
  command_toggle(studio, "map-rectangle", "Rectangle");
  ImGui::SameLine();
  command_toggle(studio, "map-lasso", "Lasso");
  separator_in_line(studio);
  command_toggle(studio, "map-pictures", "Pictures");
  ImGui::SameLine();
  command_toggle(studio, "map-sliders", "Sliders");
  ImGui::SameLine();
  command_button(studio, "frame", "Whole map");
  if (const auto& made = studio.shape_map.newest) {
    separator_in_line(studio);
    choose_map(studio, *made->table);
  }
}

void draw_map_view(Studio& studio) {
  const float scale = studio.fonts.scale;
  const std::shared_ptr<const MadeMap> made = use_shape_map(studio);
  const ImVec2 room = ImGui::GetContentRegionAvail();
  if (!made || made->map.points.empty()) {
    ImGui::Dummy({0, room.y * 0.25f});
    const bool waits =
        studio.collection.open() && (!studio.shape_map.maker.idle() || !fit_tables_settled(studio));
    empty_hint(
        studio, waits ? "The map is being made…" : "No shape is fitted yet",
        "Shapes with parts that lie and are sized alike stand near each other on the map. Fit a template to "
        "all shapes first, or learn from them.");
    const float width = std::min(room.x, 200 * scale);
    ImGui::SetCursorPosX((room.x - width) / 2);
    if (!waits) command_button(studio, "fit-all", "Fit all shapes", {width, 0});
    return;
  }
  const bool sliders = studio.ui.map.sliders;
  const float beside = sliders ? std::min(280 * scale, room.x * 0.45f) : 0;
  const float below = sliders ? std::min(112 * scale, room.y * 0.3f) : 0;
  if (sliders) use_nearest(studio, made->table);
  const ImGuiWindowFlags fixed = ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse;
  const ImVec2 corner = ImGui::GetCursorPos();
  ImGui::BeginChild("##map", {room.x - beside, room.y - below}, false, fixed);
  draw_map(studio, *made, {room.x - beside, room.y - below});
  ImGui::EndChild();
  if (!sliders) return;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {10 * scale, 6 * scale});
  ImGui::SetCursorPos({corner.x, corner.y + room.y - below});
  ImGui::BeginChild("##nearest", {room.x - beside, below}, false,
                    fixed | ImGuiWindowFlags_AlwaysUseWindowPadding);
  draw_nearest(studio);
  ImGui::EndChild();
  ImGui::SetCursorPos({corner.x + room.x - beside, corner.y});
  ImGui::BeginChild("##sliders", {beside, room.y}, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
  draw_sliders(studio, *made->table);
  ImGui::EndChild();
  ImGui::PopStyleVar();
}

}  // namespace archetype
