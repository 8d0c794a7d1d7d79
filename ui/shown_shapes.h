// The shapes that are shown: what the filter lets through, in the order asked for. One choice for the grid,
// the clusters, clouds, maps and plots.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/session/shape_filter.h"

namespace archetype {

struct Studio;

// A histogram of the filter panel, and what it was made of.
struct ShownHistogram {
  ShapeColumn column;
  Histogram all = {};
  Histogram shown = {};
  std::uint64_t of_collection = 0;
  std::uint64_t of_shown = 0;  // ShownShapes::revision
  std::shared_ptr<const FitTable> of_table = {};
};

// Plain data. Change `filter` and `order` freely; read the rest through shown_rows(studio).
struct ShownShapes {
  ShapeFilter filter;
  ShapeOrder order;
  std::vector<ShownHistogram> histograms;  // of the filter panel
  bool histograms_chosen = false;          // by hand: none come by themselves any more

  std::vector<std::size_t> rows;  // of the collection
  std::uint64_t revision = 0;     // changes with `rows`
  double milliseconds = 0;        // that it took to find them
  // What they were made of.
  std::uint64_t of_collection = 0;
  ShapeFilter of_filter;
  ShapeOrder of_order;
  std::shared_ptr<const FitTable> of_table = {};
};

// The rows of the collection to show, in their order; valid until the collection, the filter or the order
// change. Made anew where one of them did, which takes some milliseconds for 10,000 shapes.
const std::vector<std::size_t>& shown_rows(Studio& studio);
std::vector<ShapeId> shown_shape_ids(Studio& studio);
// Brings the histograms up to date; some to begin with where none were chosen yet.
void follow_histograms(Studio& studio);
// Another project is there: no condition holds any more.
void forget_filter(ShownShapes& shown);

}  // namespace archetype
