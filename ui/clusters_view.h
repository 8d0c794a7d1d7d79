// The middle of the window with the clusters: a template in each line, its members beside it.
#pragma once

#include <vector>

#include "ui/clusters_state.h"
#include "ui/shape_cell.h"

namespace archetype {

struct Studio;

// Of the pictures of members, at scale 1.
inline constexpr double least_cluster_cell = 48;
inline constexpr double most_cluster_cell = 192;

void draw_clusters_tools(Studio& studio);
void draw_clusters_view(Studio& studio);

// The clusters of what is shown, up to date.
const std::vector<ShapeCluster>& follow_clusters(Studio& studio);
ClusterKey cluster_key(const Studio& studio, const ShapeCluster& cluster);
bool is_expanded(const Studio& studio, const ShapeCluster& cluster);
void set_expanded(Studio& studio, const ClusterKey& key, bool expanded);
// The members in the order that they stand in.
std::vector<ShapeId> cluster_order(const Studio& studio);

// The shape that an arrow key leads to from the shape in view comes into view; with `extend` the selection
// grows by those on the way.
void step_in_clusters(Studio& studio, CellStep step, bool extend);

}  // namespace archetype
