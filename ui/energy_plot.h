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

// Entry i is round i. Returns the round that was clicked. Target: "energy-plot".
std::optional<std::size_t> draw_energy_plot(Studio& studio, const std::vector<PlottedRound>& rounds,
                                            std::optional<std::size_t> chosen, ImVec2 size);

}  // namespace archetype
