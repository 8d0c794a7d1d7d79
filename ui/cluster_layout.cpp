#include "ui/cluster_layout.h"

#include <algorithm>
#include <cmath>

namespace archetype {
namespace {

std::size_t lines_of(std::size_t cells, std::size_t columns) {
  return (cells + columns - 1) / columns;
}

std::size_t laid_out(const ClusterLayout& layout, const ShapeCluster& cluster, std::size_t section) {
  return std::min(cluster.shown.size(), layout.sections[section].lines * layout.columns);
}

CellPlace step_sideways(std::span<const ShapeCluster> clusters, CellPlace from, bool forwards) {
  if (forwards) {
    if (from.index + 1 < clusters[from.section].shown.size()) return {from.section, from.index + 1};
    for (std::size_t s = from.section + 1; s < clusters.size(); ++s)
      if (!clusters[s].shown.empty()) return {s, 0};
    return from;
  }
  if (from.index > 0) return {from.section, from.index - 1};
  for (std::size_t s = from.section; s-- > 0;)
    if (!clusters[s].shown.empty()) return {s, clusters[s].shown.size() - 1};
  return from;
}

CellPlace step_down(const ClusterLayout& layout, std::span<const ShapeCluster> clusters, CellPlace from) {
  const std::size_t cells = laid_out(layout, clusters[from.section], from.section);
  if (from.index + layout.columns < cells) return {from.section, from.index + layout.columns};
  // The last line may be shorter.
  if (from.index / layout.columns + 1 < lines_of(cells, layout.columns)) return {from.section, cells - 1};
  const std::size_t column = from.index % layout.columns;
  for (std::size_t s = from.section + 1; s < clusters.size(); ++s)
    if (const std::size_t next = laid_out(layout, clusters[s], s)) return {s, std::min(column, next - 1)};
  return from;
}

CellPlace step_up(const ClusterLayout& layout, std::span<const ShapeCluster> clusters, CellPlace from) {
  if (from.index >= layout.columns) return {from.section, from.index - layout.columns};
  const std::size_t column = from.index;
  for (std::size_t s = from.section; s-- > 0;) {
    const std::size_t cells = laid_out(layout, clusters[s], s);
    if (cells == 0) continue;
    const std::size_t last_line = (cells - 1) / layout.columns;
    return {s, std::min(last_line * layout.columns + column, cells - 1)};
  }
  return from;
}

}  // namespace

ClusterLayout lay_out_clusters(const ClusterMeasures& measures, std::span<const ShapeCluster> clusters,
                               std::span<const float> cards, const std::vector<bool>& expanded) {
  ClusterLayout layout;
  layout.measures = measures;
  const float room = std::max(measures.width - layout.members_left(), measures.cell_width);
  layout.columns = static_cast<std::size_t>(
      std::max(1.0f, std::floor((room + measures.gap) / (measures.cell_width + measures.gap))));
  const auto columns = static_cast<float>(layout.columns);
  layout.cell_width = std::floor((room - measures.gap * (columns - 1)) / columns);
  layout.line_height = layout.cell_width + measures.caption + measures.gap;
  float top = 0;
  for (std::size_t i = 0; i < clusters.size(); ++i) {
    ClusterSection section;
    section.top = top;
    section.card_height = cards[i];
    const std::size_t all = lines_of(clusters[i].shown.size(), layout.columns);
    const auto few = static_cast<std::size_t>(std::max(1L, std::lround(cards[i] / layout.line_height)));
    section.lines = expanded[i] ? all : std::min(all, few);
    section.cut = section.lines < all;
    section.button = section.cut || (expanded[i] && all > few);
    const float members =
        static_cast<float>(section.lines) * layout.line_height + (section.button ? measures.more_height : 0);
    section.height = std::max(section.card_height, members);
    top += section.height + measures.section_gap;
    layout.sections.push_back(section);
  }
  layout.height = top;
  return layout;
}

std::optional<CellPlace> find_cell(std::span<const ShapeCluster> clusters, std::size_t row) {
  for (std::size_t s = 0; s < clusters.size(); ++s) {
    const auto found = std::ranges::find(clusters[s].shown, row);
    if (found != clusters[s].shown.end())
      return CellPlace{s, static_cast<std::size_t>(found - clusters[s].shown.begin())};
  }
  return std::nullopt;
}

CellPlace step_cell(const ClusterLayout& layout, std::span<const ShapeCluster> clusters, CellPlace from,
                    CellStep step) {
  switch (step) {
    case CellStep::left:
      return step_sideways(clusters, from, false);
    case CellStep::right:
      return step_sideways(clusters, from, true);
    case CellStep::up:
      return step_up(layout, clusters, from);
    case CellStep::down:
      return step_down(layout, clusters, from);
  }
  return from;
}

}  // namespace archetype
