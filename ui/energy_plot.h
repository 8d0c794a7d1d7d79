// The energy over the rounds of a learning, as a plot with axes.
#pragma once

#include <imgui.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace archetype {

struct Studio;

struct PlottedRound {
  double energy = 0;
  std::string note;  // for the tooltip, below round and energy
};

// Round numbers for at most `most` marks between two values, at multiples of 1, 2 or 5 times a power of ten.
// At least two marks, one at or below `low` and one at or above `high`; most >= 3.
std::vector<double> axis_marks(double low, double high, std::size_t most);

// Entry i is round i. Returns the round that was clicked. Target: "energy-plot".
std::optional<std::size_t> draw_energy_plot(Studio& studio, const std::vector<PlottedRound>& rounds,
                                            std::optional<std::size_t> chosen, ImVec2 size);

}  // namespace archetype
