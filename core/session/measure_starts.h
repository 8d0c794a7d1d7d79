// How little it matters which template learning begins with (figure 11).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/session/learn_templates.h"
#include "core/session/truth_shares.h"

namespace archetype {

// One template to begin with, and what came of it.
struct StartMeasure {
  PartTemplate initial;
  std::vector<PartTemplate> learned;
  double energy_before = 0;  // mean of the fits of `initial` to all of the shapes
  double energy_after = 0;   // the same of what was learned
  TruthShares before;
  TruthShares after;
  GroundTruthFolders truth;  // that these are against
  friend bool operator==(const StartMeasure&, const StartMeasure&) = default;
};

inline constexpr std::size_t most_starts = 6;  // the paper's number of them

// Fits each of the templates to the shapes, 200 random ones at most, and learns from it; the project is not
// changed. `truth`: empty folders where none is known. Nothing if cancelled. Takes as long as that many
// learnings. Throws PreconditionError without shapes.
std::optional<std::vector<StartMeasure>> measure_starts(const Project& project,
                                                        const std::vector<PartTemplate>& starts,
                                                        const GroundTruthFolders& truth, std::uint64_t seed,
                                                        unsigned threads, const JobControl& control);
// The same from the templates that are suggested for the shapes, the best most_starts of them.
std::optional<std::vector<StartMeasure>> measure_suggested_starts(const Project& project,
                                                                  const GroundTruthFolders& truth,
                                                                  std::uint64_t seed, unsigned threads,
                                                                  const JobControl& control);

// The project keeps them, so that they need not be measured again to be looked at.
void store_start_measures(Project& project, const std::vector<StartMeasure>& measures);
// Empty where none are stored or what is stored cannot be read.
std::vector<StartMeasure> stored_start_measures(const Project& project);

}  // namespace archetype
