// One histogram that is brushed: dragged over, it bounds the number that it shows.
#pragma once

#include <imgui.h>

#include <optional>
#include <string>

#include "core/session/shape_columns.h"

namespace archetype {

struct Studio;

struct PlottedHistogram {
  const Histogram* all = nullptr;
  const Histogram* shown = nullptr;                // of what the filter lets through, over the same range
  std::optional<std::pair<double, double>> range;  // that the filter has
};

enum class Brushed { no, changed, cleared };
// Of `size`, at the cursor; the item is marked as `target`. While it is dragged over, `range` is what is
// brushed; a double click clears it.
Brushed draw_histogram(Studio& studio, const std::string& target, const PlottedHistogram& plotted,
                       ImVec2 size, std::pair<double, double>& range);

// With as many digits as a person needs: "0.153", "1,240".
std::string plotted_number(double value);

}  // namespace archetype
