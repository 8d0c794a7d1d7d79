#include "ui/clusters_view.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/cluster_card.h"
#include "ui/histogram_plot.h"
#include "ui/icons.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

ClusterMeasures measures_of(const Studio& studio, float width) {
  const float scale = studio.fonts.scale;
  ClusterMeasures measures;
  measures.width = width;
  measures.card_width = std::min(214 * scale, width * 0.45f);
  measures.cell_width = std::min(static_cast<float>(studio.ui.clusters.cell_size) * scale, width * 0.5f);
  measures.caption = 20 * scale;
  measures.gap = 6 * scale;
  measures.section_gap = 18 * scale;
  measures.more_height = ImGui::GetFrameHeight() + 4 * scale;
  return measures;
}

void draw_cell(Studio& studio, const ShapeCluster& cluster, std::size_t row, ImVec2 size) {
  const ShapeRow& shape = studio.collection.rows()[row];
  const std::vector<double>& values = studio.ui.clusters.values;
  ShapeCell cell{.target = "cluster-cell", .note = "", .size = size};
  if (row < values.size() && std::isfinite(values[row])) cell.note = plotted_number(values[row]);
  cell.offers_template = cluster.kind == ClusterKind::outliers;
  const ShapeId id = shape.id;
  const CellClick click = draw_shape_cell(studio, shape, cell);
  if (click == CellClick::none) return;
  take_click(studio, click, id, click == CellClick::extend ? cluster_order(studio) : std::vector<ShapeId>());
  studio.ui.grid.scroll_to_shape = true;
}

struct Sight {
  ImVec2 origin;  // of everything, on the screen
  float low = 0;  // what is seen, from the top of everything
  float high = 0;
  bool sees(float top, float height) const { return top < high && top + height > low; }
};

void draw_members(Studio& studio, std::size_t place, const Sight& sight) {
  const ClusterLayout& layout = studio.ui.clusters.layout;
  const ClusterSection section = layout.sections[place];
  const ShapeCluster& cluster = studio.ui.clusters.clusters[place];
  const auto first = static_cast<std::size_t>(std::max(0.0f, (sight.low - section.top) / layout.line_height));
  for (std::size_t line = first; line < section.lines; ++line) {
    const float top = layout.cell_top(place, line);
    if (top >= sight.high) break;
    for (std::size_t column = 0; column < layout.columns; ++column) {
      const std::size_t index = line * layout.columns + column;
      if (index >= cluster.shown.size()) break;
      ImGui::SetCursorScreenPos({sight.origin.x + layout.cell_left(column), sight.origin.y + top});
      draw_cell(studio, cluster, cluster.shown[index],
                {layout.cell_width, layout.line_height - layout.measures.gap});
    }
  }
}

// What comes next when one scrolls on is made while there is time.
void expect_next(Studio& studio, std::size_t place, const Sight& sight) {
  const ClusterLayout& layout = studio.ui.clusters.layout;
  const ClusterSection& section = layout.sections[place];
  const ShapeCluster& cluster = studio.ui.clusters.clusters[place];
  const float page = sight.high - sight.low;
  for (std::size_t line = 0; line < section.lines; ++line) {
    const float top = layout.cell_top(place, line);
    if (top < sight.high || top > sight.high + page) continue;
    for (std::size_t column = 0; column < layout.columns; ++column)
      if (const std::size_t index = line * layout.columns + column; index < cluster.shown.size())
        studio.thumbnails.expect(shown_thumbnail(studio, studio.collection.rows()[cluster.shown[index]]));
  }
}

void draw_more(Studio& studio, std::size_t place, const Sight& sight) {
  const ClusterLayout& layout = studio.ui.clusters.layout;
  const ClusterSection& section = layout.sections[place];
  const ShapeCluster& cluster = studio.ui.clusters.clusters[place];
  const std::size_t laid_out = section.lines * layout.columns;
  const float top = layout.cell_top(place, section.lines);
  const bool wanted = is_expanded(studio, cluster);
  if (!section.button || !(section.cut || wanted) || !sight.sees(top, layout.measures.more_height)) return;
  ImGui::SetCursorScreenPos({sight.origin.x + layout.members_left(), sight.origin.y + top});
  ImGui::PushID(static_cast<int>(place));
  const std::string text =
      section.cut ? std::string(icon::down) + "  " +
                        count_text(cluster.shown.size() - std::min(laid_out, cluster.shown.size())) + " more"
                  : std::string(icon::up) + "  Fewer";
  if (ImGui::Button((text + "###more").c_str()))
    set_expanded(studio, cluster_key(studio, cluster), section.cut);
  mark_target(studio, "cluster-more:" + std::to_string(place));
  ImGui::PopID();
}

// Stays in sight as long as its members are.
void draw_card(Studio& studio, std::size_t place, const Sight& sight) {
  ClustersState& state = studio.ui.clusters;
  const ClusterSection section = state.layout.sections[place];
  const float lowest = section.top + std::max(0.0f, section.height - state.cards[place]);
  const float top = std::clamp(sight.low, section.top, lowest);
  ImGui::SetCursorScreenPos({sight.origin.x, sight.origin.y + top});
  state.cards[place] = draw_cluster_card(studio, state.clusters[place], state.layout.measures.card_width);
}

// What has room in its share of the page is shown whole, and the rest fills its share; so is what stands
// alone.
void lay_out(Studio& studio, float width, float page) {
  ClustersState& state = studio.ui.clusters;
  const ClusterMeasures measures = measures_of(studio, width);
  std::vector<bool> expanded(state.clusters.size());
  std::vector<float> cards = state.cards;
  const ClusterLayout rough = lay_out_clusters(measures, state.clusters, cards, expanded);
  const auto filled = static_cast<std::size_t>(std::ranges::count_if(
      state.clusters, [](const ShapeCluster& cluster) { return !cluster.shown.empty(); }));
  const float share = page / static_cast<float>(std::max<std::size_t>(filled, 1)) - measures.section_gap;
  for (std::size_t i = 0; i < cards.size(); ++i) {
    const std::size_t lines = (state.clusters[i].shown.size() + rough.columns - 1) / rough.columns;
    const bool fits = static_cast<float>(lines) * rough.line_height <= std::max(cards[i], share);
    expanded[i] = fits || filled == 1 || is_expanded(studio, state.clusters[i]);
    if (!expanded[i]) cards[i] = std::max(cards[i], share);
  }
  state.layout = lay_out_clusters(measures, state.clusters, cards, expanded);
}

void scroll(Studio& studio, float page) {
  ClustersState& state = studio.ui.clusters;
  if (const auto wanted = std::exchange(state.wanted_scroll, std::nullopt)) ImGui::SetScrollY(*wanted);
  state.scroll = ImGui::GetScrollY();
  state.most_scroll = std::max(0.0f, state.layout.height - page);
  if (!std::exchange(state.scroll_to_shape, false) || !studio.ui.shape) return;
  const std::optional<std::size_t> row = find_row(studio.collection, *studio.ui.shape);
  const auto at = row ? find_cell(state.clusters, *row) : std::nullopt;
  if (!at) return;
  const float top = state.layout.cell_top(at->section, at->index / state.layout.columns);
  if (top < state.scroll) ImGui::SetScrollY(top);
  if (top + state.layout.line_height > state.scroll + page)
    ImGui::SetScrollY(top + state.layout.line_height - page);
}

void zoom_cells(Studio& studio) {
  const ImGuiIO& io = ImGui::GetIO();
  if (!io.KeyCtrl || io.MouseWheel == 0 || !ImGui::IsWindowHovered()) return;
  double& size = studio.ui.clusters.cell_size;
  size = std::clamp(size * std::pow(1.1, static_cast<double>(io.MouseWheel)), least_cluster_cell,
                    most_cluster_cell);
}

void draw_all(Studio& studio) {
  ClustersState& state = studio.ui.clusters;
  const bool zooming = ImGui::GetIO().KeyCtrl;
  ImGui::BeginChild("##clusters", {0, 0}, false, zooming ? ImGuiWindowFlags_NoScrollWithMouse : 0);
  zoom_cells(studio);
  const float width = ImGui::GetContentRegionAvail().x;
  const float page = ImGui::GetWindowHeight();
  lay_out(studio, width, page);
  scroll(studio, page);
  const Sight sight{ImGui::GetCursorScreenPos(), ImGui::GetScrollY(), ImGui::GetScrollY() + page};
  for (std::size_t i = 0; i < state.clusters.size(); ++i) {
    const ClusterSection section = state.layout.sections[i];
    if (!sight.sees(section.top, section.height)) continue;
    draw_card(studio, i, sight);
    draw_members(studio, i, sight);
    draw_more(studio, i, sight);
  }
  for (std::size_t i = 0; i < state.clusters.size(); ++i)
    if (sight.sees(state.layout.sections[i].top, state.layout.sections[i].height + page))
      expect_next(studio, i, sight);
  ImGui::SetCursorScreenPos(sight.origin);
  ImGui::Dummy({width, state.layout.height});
  ImGui::EndChild();
}

}  // namespace

void draw_clusters_view(Studio& studio) {
  if (!studio.collection.open() || studio.collection.rows().empty()) {
    empty_hint(studio, "No shapes yet",
               "Open a folder of shapes: they stand here by the template that explains them.");
    return;
  }
  const auto& clusters = follow_clusters(studio);
  const bool nothing_fitted =
      std::ranges::none_of(studio.collection.rows(), [](const ShapeRow& row) { return row.fit.has_value(); });
  if (nothing_fitted && clusters.size() <= 1) {
    empty_hint(studio, "No clusters yet",
               "Learn from the shapes, or fit a template to all of them: each shape then stands beside the "
               "template that explains it best.");
    const float width = 220 * studio.fonts.scale;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + (ImGui::GetContentRegionAvail().x - width) / 2);
    const bool has_template = studio.history.current().active_template() != nullptr;
    if (has_template)
      command_button(studio, "learn", std::string(icon::play) + "  Learn from all shapes", {width, 0});
    else
      command_button(studio, "learn-automatically", std::string(icon::play) + "  Learn from the shapes alone",
                     {width, 0});
    return;
  }
  if (shown_rows(studio).empty()) {
    empty_hint(studio, "No shape is left", "Clear the search or the filter to see all of them.");
    const float width = 140 * studio.fonts.scale;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + (ImGui::GetContentRegionAvail().x - width) / 2);
    command_button(studio, "clear-filter", "Show all shapes", {width, 0});
    return;
  }
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {10 * studio.fonts.scale, 8 * studio.fonts.scale});
  ImGui::BeginChild("##padded", {0, 0}, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
  ImGui::PopStyleVar();
  draw_all(studio);
  ImGui::EndChild();
}

}  // namespace archetype
