// Where the clusters stand in their view: one section each below the other, the card of the template on the
// left, its members on the right. Plain geometry, so that only what is in sight is drawn.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/session/shape_clusters.h"

namespace archetype {

struct ClusterMeasures {  // screen units
  float width = 800;      // of everything
  float card_width = 210;
  float cell_width = 112;  // at least; what is left over is shared out
  float caption = 20;      // of a cell, below its picture
  float gap = 6;
  float section_gap = 14;
  float more_height = 24;  // of the button below members that are not all shown
};

struct ClusterSection {
  float top = 0;  // from the top of everything
  float height = 0;
  float card_height = 0;
  std::size_t lines = 0;  // that are laid out
  bool cut = false;       // more members are there than the lines hold
  bool button = false;    // to lay out all of them, or about as many as stand beside the card
};

struct ClusterLayout {
  ClusterMeasures measures;
  std::size_t columns = 1;
  float cell_width = 112;
  float line_height = 138;  // with the gap
  std::vector<ClusterSection> sections;
  float height = 0;  // of everything

  float members_left() const { return measures.card_width + 2 * measures.gap; }
  float cell_left(std::size_t column) const {
    return members_left() + static_cast<float>(column) * (cell_width + measures.gap);
  }
  float cell_top(std::size_t section, std::size_t line) const {
    return sections[section].top + static_cast<float>(line) * line_height;
  }
};

// `cards` and `expanded` hold one entry per cluster: the height of its card, and whether all members are laid
// out rather than about as many lines as stand beside the card.
ClusterLayout lay_out_clusters(const ClusterMeasures& measures, std::span<const ShapeCluster> clusters,
                               std::span<const float> cards, const std::vector<bool>& expanded);

struct CellPlace {
  std::size_t section = 0;
  std::size_t index = 0;  // among the shown members
  friend bool operator==(const CellPlace&, const CellPlace&) = default;
};
std::optional<CellPlace> find_cell(std::span<const ShapeCluster> clusters, std::size_t row);

// The cell that an arrow key leads to: within lines, from section to section, and over the edge to the next
// section that is not empty. Stays where there is none. Only cells that are laid out count upwards and down;
// sideways all members do.
enum class CellStep { left, right, up, down };
CellPlace step_cell(const ClusterLayout& layout, std::span<const ShapeCluster> clusters, CellPlace from,
                    CellStep step);

}  // namespace archetype
