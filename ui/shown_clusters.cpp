// Which clusters are shown, in which order, and the steps from one member to the next.
#include <algorithm>

#include "ui/cluster_card.h"
#include "ui/clusters_view.h"
#include "ui/studio.h"

namespace archetype {

std::vector<ShapeId> cluster_order(const Studio& studio) {
  std::vector<ShapeId> ids;
  for (const ShapeCluster& cluster : studio.ui.clusters.clusters)
    for (const std::size_t row : cluster.shown) ids.push_back(studio.collection.rows()[row].id);
  return ids;
}

ClusterKey cluster_key(const Studio& studio, const ShapeCluster& cluster) {
  if (cluster.kind != ClusterKind::members || !studio.ui.clusters.of_table) return {cluster.kind, 0};
  return {cluster.kind, studio.ui.clusters.of_table->templates[cluster.part_template].id};
}

bool is_expanded(const Studio& studio, const ShapeCluster& cluster) {
  const auto& expanded = studio.ui.clusters.expanded;
  return std::ranges::find(expanded, cluster_key(studio, cluster)) != expanded.end();
}

void set_expanded(Studio& studio, const ClusterKey& key, bool expanded) {
  std::erase(studio.ui.clusters.expanded, key);
  if (expanded) studio.ui.clusters.expanded.push_back(key);
}

const std::vector<ShapeCluster>& follow_clusters(Studio& studio) {
  ClustersState& state = studio.ui.clusters;
  const std::vector<std::size_t>& rows = shown_rows(studio);
  const std::shared_ptr<const FitTable> table = use_fit_table(studio);
  if (state.of_shown == studio.ui.shown.revision && state.of_table == table) return state.clusters;
  const ShapeTable shapes(studio.collection.rows(), table.get());
  const ShapeOrder& order = studio.ui.shown.order;
  const bool by_name = order.column.quantity == ShapeQuantity::name;
  state.clusters = shape_clusters(shapes, rows, by_name && !order.descending);
  state.values = by_name ? std::vector<double>() : column_values(shapes, order.column);
  state.of_shown = studio.ui.shown.revision;
  state.of_table = table;
  state.cards.resize(state.clusters.size(), guessed_card_height(studio));
  return state.clusters;
}

void step_in_clusters(Studio& studio, CellStep step, bool extend) {
  ClustersState& state = studio.ui.clusters;
  follow_clusters(studio);
  if (state.layout.sections.size() != state.clusters.size()) return;  // not drawn yet
  const std::optional<std::size_t> row =
      studio.ui.shape ? find_row(studio.collection, *studio.ui.shape) : std::nullopt;
  const auto from = row ? find_cell(state.clusters, *row) : std::nullopt;
  const std::vector<ShapeId> order = cluster_order(studio);
  if (order.empty()) return;
  ShapeId next = order.front();
  if (from) {
    const CellPlace to = step_cell(state.layout, state.clusters, *from, step);
    next = studio.collection.rows()[state.clusters[to.section].shown[to.index]].id;
    // Members that are not laid out cannot be shown where they stand.
    const std::size_t laid_out = state.layout.sections[to.section].lines * state.layout.columns;
    if (to.index >= laid_out) set_expanded(studio, cluster_key(studio, state.clusters[to.section]), true);
  }
  if (extend)
    add_to_selection(studio.ui.selection, range_of(order, studio.ui.shape, next));
  else
    select_only(studio.ui.selection, {next});
  show_shape(studio, next);
  state.scroll_to_shape = true;
  studio.ui.grid.scroll_to_shape = true;
}

}  // namespace archetype
