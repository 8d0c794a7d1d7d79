#include "ui/shape_map_view.h"

#include <algorithm>

#include "ui/plot_sources.h"
#include "ui/shape_map_paint.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

// With pictures of that side whole at the edges, too.
void fit_whole(MapState& state, const ShapeMap& map, const MapSpace& space, float side) {
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
  const auto without = [&](float length) { return std::max(0.4f * length, 0.95f * length - side); };
  const ImVec2 room(without(space.size().x), std::max(1.0f, without(space.size().y)));
  const float wide = std::max(high[0] - low[0], 1e-3f);
  const float tall = std::max(high[1] - low[1], 1e-3f);
  state.zoom = std::max(1e-6, std::min<double>(room.x / wide, room.y / tall));
}

void draw_map(Studio& studio, const MadeMap& made, ImVec2 size) {
  MapState& state = studio.ui.map;
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float legend = draw_map_legend(studio, made, low, size.x, size.y);
  const float axes = axes_height(made);
  const MapSpace space{{low.x, low.y + legend},
                       {low.x + size.x, low.y + std::max(legend + 1, size.y - axes)}};
  draw_map_axes(studio, made, {low.x, space.high.y}, size.x);
  if (studio.ui.wanted_frame || studio.ui.wanted_view) state.whole = true;
  studio.ui.wanted_frame = false;
  studio.ui.wanted_view.reset();
  const float side = std::clamp(space.size().y / 8, 44 * studio.fonts.scale, 84 * studio.fonts.scale);
  if (state.whole) fit_whole(state, made.map, space, side);
  const std::vector<std::size_t> shown =
      state.pictures ? pictured_points(state, made.map, space, side) : std::vector<std::size_t>();
  ImGui::PushClipRect(space.low, space.high, true);
  follow_map_mouse(studio, made, space, shown, side);
  draw_map_points(studio, made, space, shown, side);
  draw_map_outline(studio);
  ImGui::PopClipRect();
}

void choose_map(Studio& studio, const FitTable& table) {
  MapState& state = studio.ui.map;
  std::string name = "All templates";
  for (const TemplateRecord& record : table.templates)
    if (record.id == state.of) name = record.part_template.name;
  const auto choose = [&](std::optional<TemplateId> of) {
    state.of = of;
    state.whole = true;
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
