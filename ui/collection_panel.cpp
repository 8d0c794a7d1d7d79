// The collection as a grid of pictures. Only the cells in sight are drawn and asked for, so that ten thousand
// are no more work than ten.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "ui/icons.h"
#include "ui/panels.h"
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

void follow_rows(Studio& studio) {
  GridState& grid = studio.ui.grid;
  if (grid.visible_revision == studio.collection.revision && grid.visible_filter == grid.filter &&
      grid.visible_order == grid.order)
    return;
  grid.visible = visible_rows(studio.collection.rows(), grid.filter, grid.order);
  grid.visible_revision = studio.collection.revision;
  grid.visible_filter = grid.filter;
  grid.visible_order = grid.order;
}

void draw_head(Studio& studio) {
  GridState& grid = studio.ui.grid;
  ImGui::PushFont(studio.fonts.bold);
  ImGui::TextUnformatted(fitted(studio.collection.title, ImGui::GetContentRegionAvail().x).c_str());
  ImGui::PopFont();
  const std::size_t all = studio.collection.rows().size();
  std::string count = count_text(all) + (all == 1 ? " shape" : " shapes");
  if (grid.visible.size() != all) count = count_text(grid.visible.size()) + " of " + count;
  if (!studio.collection.content.refused.empty())
    count += ", " + count_text(studio.collection.content.refused.size()) + " refused";
  muted_text(studio, count);
  const float order_width = 108 * studio.fonts.scale;
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - order_width - ImGui::GetStyle().ItemSpacing.x);
  ImGui::InputTextWithHint("##filter", (std::string(icon::search) + "  Search names").c_str(), &grid.filter);
  mark_target(studio, "grid:filter");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(order_width);
  const char* orders[] = {"Name", "Best fit", "Worst fit", "Most faces"};
  int order = static_cast<int>(grid.order);
  if (ImGui::Combo("##order", &order, orders, 4)) grid.order = static_cast<RowOrder>(order);
  mark_target(studio, "grid:order");
}

// The picture, or a quiet frame until it has been made.
void draw_picture(Studio& studio, const ShapeRow& row, ImVec2 low, float side) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const float rounding = 6 * studio.fonts.scale;
  const ImVec2 high(low.x + side, low.y + side);
  if (const std::uint32_t texture = studio.thumbnails.use(wanted_thumbnail(row))) {
    // Rows of pictures run from the top, as Dear ImGui's textures do.
    draw->AddImageRounded(reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(texture)), low, high,
                          {0, 0}, {1, 1}, IM_COL32_WHITE, rounding);
    return;
  }
  const ImVec4 muted = colours(studio).muted;
  const ImVec2 size = ImGui::CalcTextSize(icon::cube);
  draw->AddText({low.x + (side - size.x) / 2, low.y + (side - size.y) / 2},
                ImGui::GetColorU32({muted.x, muted.y, muted.z, 0.4f}), icon::cube);
}

void draw_cell(Studio& studio, const ShapeRow& row, float side, float height) {
  const Palette& p = colours(studio);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const ImVec2 high(low.x + side, low.y + height);
  ImGui::PushID(static_cast<int>(row.id));
  if (ImGui::InvisibleButton("cell", {side, height})) show_shape(studio, row.id);
  mark_target(studio, "cell:" + row.name);
  const bool chosen = studio.ui.shape == row.id;
  const bool hovered = ImGui::IsItemHovered();
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const float rounding = 6 * studio.fonts.scale;
  draw->AddRectFilled(low, high, ImGui::GetColorU32(hovered || chosen ? p.hovered : p.raised), rounding);
  draw_picture(studio, row, low, side);
  if (chosen) draw->AddRect(low, high, ImGui::GetColorU32(p.accent), rounding, 0, 2 * studio.fonts.scale);
  ImGui::PushFont(studio.fonts.small);
  const std::string name = fitted(row.name, side - 10 * studio.fonts.scale);
  const float x = low.x + (side - ImGui::CalcTextSize(name.c_str()).x) / 2;
  draw->AddText({x, high.y - ImGui::GetTextLineHeight() - 4 * studio.fonts.scale},
                ImGui::GetColorU32(chosen ? p.text : p.muted), name.c_str());
  ImGui::PopFont();
  if (hovered) {
    std::string text = row.name + "\n" + count_text(row.element_count) + " faces or points";
    if (row.fit) {
      char energy[64];
      std::snprintf(energy, sizeof energy, "\nfit: energy %.3f, yaw %d°", row.fit->energy.total(),
                    row.fit->yaw_quarters * 90);
      text += energy;
    }
    tooltip(text.c_str());
  }
  ImGui::PopID();
}

void scroll_to_shape(Studio& studio, int columns, float line_height) {
  if (!std::exchange(studio.ui.grid.scroll_to_shape, false) || !studio.ui.shape) return;
  const auto& visible = studio.ui.grid.visible;
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
  const GridState& grid = studio.ui.grid;
  const float gap = 6 * studio.fonts.scale;
  const float space = ImGui::GetContentRegionAvail().x;
  const float wanted = static_cast<float>(studio.settings.cell_size) * studio.fonts.scale;
  const int columns = std::max(1, static_cast<int>((space + gap) / (wanted * 0.85f + gap)));
  const float side =
      std::floor((space - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns));
  const float height = side + 20 * studio.fonts.scale;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {gap, gap});
  scroll_to_shape(studio, columns, height + gap);
  ImGuiListClipper clipper;
  clipper.Begin((static_cast<int>(grid.visible.size()) + columns - 1) / columns, height + gap);
  while (clipper.Step()) {
    for (int line = clipper.DisplayStart; line < clipper.DisplayEnd; ++line) {
      for (int column = 0; column < columns; ++column) {
        const auto index = static_cast<std::size_t>(line) * static_cast<std::size_t>(columns) +
                           static_cast<std::size_t>(column);
        if (index >= grid.visible.size()) break;
        if (column > 0) ImGui::SameLine();
        draw_cell(studio, rows[grid.visible[index]], side, height);
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
  follow_rows(studio);
  draw_head(studio);
  ImGui::BeginChild("cells", {0, 0});
  if (studio.collection.rows().empty()) {
    const bool reading = !studio.jobs.idle();
    empty_hint(studio, reading ? "Reading…" : "No shapes here",
               reading ? "Shapes appear as they are read."
                       : "Nothing in the folder could be read as a shape; the messages say why.");
  } else if (studio.ui.grid.visible.empty()) {
    empty_hint(studio, "No shape has this in its name", "Clear the search to see all of them.");
  } else {
    draw_cells(studio);
  }
  ImGui::EndChild();
}

}  // namespace archetype
