// What is chosen in the view of the clusters, and what it shows. Plain data, not undoable.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/session/shape_clusters.h"
#include "ui/cluster_layout.h"

namespace archetype {

// Which cluster it is, whatever comes and goes around it.
struct ClusterKey {
  ClusterKind kind = ClusterKind::members;
  TemplateId part_template = 0;  // of members
  friend bool operator==(const ClusterKey&, const ClusterKey&) = default;
};

struct ClustersState {
  std::vector<ClusterKey> expanded;    // all of their members are laid out
  double cell_size = 104;              // of the thumbnails, at scale 1
  bool spread = true;                  // of the parts, in the pictures of the templates
  bool scroll_to_shape = false;        // bring the shape in view into sight, once
  std::optional<float> wanted_scroll;  // from the top, screen units; of scripts
  float scroll = 0;                    // that it has now
  float most_scroll = 0;

  // Made anew when what is shown changes.
  std::vector<ShapeCluster> clusters;
  std::vector<double> values;  // of all rows, by which they are sorted; empty: by name
  std::vector<float> cards;    // the heights that the cards had in the last frame
  ClusterLayout layout;        // of the last frame
  std::uint64_t of_shown = 0;  // ShownShapes::revision
  std::shared_ptr<const FitTable> of_table;
};

}  // namespace archetype
