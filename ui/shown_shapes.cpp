#include "ui/shown_shapes.h"

#include <algorithm>
#include <chrono>
#include <numeric>

#include "ui/studio.h"

namespace archetype {

const std::vector<std::size_t>& shown_rows(Studio& studio) {
  ShownShapes& shown = studio.ui.shown;
  std::shared_ptr<const FitTable> table;
  if (needs_fit_table(shown.filter) || needs_fit_table(shown.order.column)) table = use_fit_table(studio);
  if (shown.of_collection == studio.collection.revision && shown.of_table == table &&
      shown.of_filter == shown.filter && shown.of_order == shown.order)
    return shown.rows;
  const auto start = std::chrono::steady_clock::now();
  shown.rows = shown_rows(ShapeTable(studio.collection.rows(), table.get()), shown.filter, shown.order);
  ++shown.revision;
  shown.of_collection = studio.collection.revision;
  shown.of_table = std::move(table);
  shown.of_filter = shown.filter;
  shown.of_order = shown.order;
  const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
  shown.milliseconds = took.count();
  return shown.rows;
}

std::vector<ShapeId> shown_shape_ids(Studio& studio) {
  std::vector<ShapeId> ids;
  for (const std::size_t row : shown_rows(studio)) ids.push_back(studio.collection.rows()[row].id);
  return ids;
}

void follow_histograms(Studio& studio) {
  ShownShapes& shown = studio.ui.shown;
  const std::vector<std::size_t>& rows = shown_rows(studio);
  const std::shared_ptr<const FitTable> table = use_fit_table(studio);
  if (!shown.histograms_chosen && shown.histograms.empty() && table && !table->rows.empty())
    for (ShapeColumn& column : telling_columns(*table, 4)) shown.histograms.push_back({std::move(column)});
  const auto stale = [&](const ShownHistogram& each) {
    return each.of_collection != studio.collection.revision || each.of_shown != shown.revision ||
           each.of_table != table || each.all.counts.empty();
  };
  if (std::ranges::none_of(shown.histograms, stale)) return;
  const ShapeTable shapes(studio.collection.rows(), table.get());
  std::vector<std::size_t> all(studio.collection.rows().size());
  std::iota(all.begin(), all.end(), 0U);
  constexpr std::size_t bins = 40;
  for (ShownHistogram& each : shown.histograms) {
    if (!stale(each)) continue;
    const std::vector<double> values = column_values(shapes, each.column);
    each.all = histogram(values, all, bins);
    each.shown = histogram(values, rows, bins);
    each.of_collection = studio.collection.revision;
    each.of_shown = shown.revision;
    each.of_table = table;
  }
}

void forget_filter(ShownShapes& shown) {
  shown.filter = {};
  shown.order = {};
  shown.histograms.clear();
  shown.histograms_chosen = false;
}

}  // namespace archetype
