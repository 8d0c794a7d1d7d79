// The collection as a grid of pictures. Only the cells in sight are drawn and asked for, so that ten thousand
// are no more work than ten.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/filter_panel.h"
#include "ui/icons.h"
#include "ui/order_menu.h"
#include "ui/panels.h"
#include "ui/shape_cell.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

void draw_empty(Studio& studio) {
  empty_hint(studio, "No shapes yet",
             "Open a folder of chairs, planes or lamps as they come, drop one on the window, or look at what "
             "is there "
             "already.");
  const float width = std::min(ImGui::GetContentRegionAvail().x, 240 * studio.fonts.scale);
  const float indent = (ImGui::GetContentRegionAvail().x - width) / 2;
  ImGui::Dummy({0, 6 * studio.fonts.scale});
  const std::pair<const char*, std::string> buttons[] = {
      {"open-folder", std::string(icon::folder_open) + "  Open folder…"},
      {"open-project", std::string(icon::file) + "  Open project…"},
      {"open-seats", std::string(icon::cubes) + "  Seats of Sweet Home 3D"},
      {"generate-chairs", std::string(icon::cube) + "  Generate chairs"}};
  for (const auto& [command, label] : buttons) {
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + indent);
    command_button(studio, command, label, {width, 0});
  }
}

void draw_head(Studio& studio) {
  ShownShapes& shown = studio.ui.shown;
  ImGui::PushFont(studio.fonts.bold);
  ImGui::TextUnformatted(fitted(studio.collection.title, ImGui::GetContentRegionAvail().x).c_str());
  ImGui::PopFont();
  const std::size_t all = studio.collection.rows().size();
  std::string count = count_text(all) + (all == 1 ? " shape" : " shapes");
  if (const std::size_t some = shown_rows(studio).size(); some != all)
    count = count_text(some) + " of " + count;
  if (!studio.collection.content.refused.empty())
    count += ", " + count_text(studio.collection.content.refused.size()) + " refused";
  muted_text(studio, count);
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float room = ImGui::GetContentRegionAvail().x;
  const float filter_width = ImGui::GetFrameHeight();
  float order_width = 96 * studio.fonts.scale;
  const float search_room = room - order_width - filter_width - 2 * gap;
  // A narrow panel has a line for the search alone.
  const bool own_line = search_room < 90 * studio.fonts.scale;
  if (own_line) order_width = room - filter_width - gap;
  ImGui::SetNextItemWidth(own_line ? -1 : search_room);
  ImGui::InputTextWithHint("##filter", (std::string(icon::search) + "  Search").c_str(), &shown.filter.name);
  mark_target(studio, "grid:filter");
  if (!own_line) ImGui::SameLine();
  draw_order_button(studio, "grid:order", order_width);
  ImGui::SameLine();
  draw_filter_button(studio, filter_width);
}

void draw_cell(Studio& studio, ShapeId id, const ShapeRow& row, ImVec2 size) {
  CellClick click = draw_shape_cell(studio, row, {.target = "cell", .note = "", .size = size});
  if (click == CellClick::none) return;
  // A double click would only change what is looked at while one edits.
  if (click == CellClick::open && studio.ui.centre == CentreView::shape) click = CellClick::only;
  take_click(studio, click, id,
             click == CellClick::extend ? shown_shape_ids(studio) : std::vector<ShapeId>());
  studio.ui.clusters.scroll_to_shape = true;
}

void scroll_to_shape(Studio& studio, int columns, float line_height) {
  if (!std::exchange(studio.ui.grid.scroll_to_shape, false) || !studio.ui.shape) return;
  const auto& visible = shown_rows(studio);
  const auto at = std::find_if(visible.begin(), visible.end(), [&](std::size_t row) {
    return studio.collection.rows()[row].id == studio.ui.shape;
  });
  if (at == visible.end()) return;
  const auto line = (at - visible.begin()) / columns;
  const float top = static_cast<float>(line) * line_height;
  const float space = ImGui::GetWindowHeight();
  if (top < ImGui::GetScrollY() || top + line_height > ImGui::GetScrollY() + space)
    ImGui::SetScrollY(std::max(0.0f, top - (space - line_height) / 2));
}

void draw_cells(Studio& studio) {
  const auto& rows = studio.collection.rows();
  const auto& visible = shown_rows(studio);
  const float gap = 6 * studio.fonts.scale;
  const float space = ImGui::GetContentRegionAvail().x;
  const float wanted = static_cast<float>(studio.settings.cell_size) * studio.fonts.scale;
  const int columns = std::max(1, static_cast<int>((space + gap) / (wanted * 0.85f + gap)));
  const float side =
      std::floor((space - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns));
  const float height = side + 20 * studio.fonts.scale;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {gap, gap});
  if (const auto place = std::exchange(studio.ui.grid.wanted_scroll, std::nullopt)) ImGui::SetScrollY(*place);
  studio.ui.grid.scroll = ImGui::GetScrollY();
  studio.ui.grid.most_scroll = ImGui::GetScrollMaxY();
  scroll_to_shape(studio, columns, height + gap);
  ImGuiListClipper clipper;
  clipper.Begin((static_cast<int>(visible.size()) + columns - 1) / columns, height + gap);
  while (clipper.Step()) {
    for (int line = clipper.DisplayStart; line < clipper.DisplayEnd; ++line) {
      for (int column = 0; column < columns; ++column) {
        const auto index = static_cast<std::size_t>(line) * static_cast<std::size_t>(columns) +
                           static_cast<std::size_t>(column);
        if (index >= visible.size()) break;
        if (column > 0) ImGui::SameLine();
        draw_cell(studio, rows[visible[index]].id, rows[visible[index]], {side, height});
      }
    }
  }
  ImGui::PopStyleVar();
}

}  // namespace

void draw_collection_panel(Studio& studio) {
  if (!studio.collection.open()) {
    draw_empty(studio);
    return;
  }
  draw_head(studio);
  ImGui::BeginChild("cells", {0, 0});
  if (studio.collection.rows().empty()) {
    const bool reading = !studio.jobs.idle();
    empty_hint(
        studio, reading ? "Reading…" : "No shapes here",
        reading ? "Shapes appear as they are read."
        : studio.collection.content.refused.empty()
            ? "There is no file of a kind that is read: OBJ, OFF, PLY, STL, glTF, GLB, AC3D, XYZ, PTS or "
              "binvox. \"Add shapes…\" in the menu File brings some in."
            : "None of the files could be read as a shape; the messages say why.");
  } else if (shown_rows(studio).empty()) {
    empty_hint(studio, "No shape is left", "Clear the search or the filter to see all of them.");
    const float width = 140 * studio.fonts.scale;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + (ImGui::GetContentRegionAvail().x - width) / 2);
    command_button(studio, "clear-filter", "Show all shapes", {width, 0});
  } else {
    draw_cells(studio);
  }
  ImGui::EndChild();
}

}  // namespace archetype
