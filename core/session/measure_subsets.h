// How learning grows with the collection (figure 12): accuracy on other shapes, time and templates over its
// size.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/session/learn_templates.h"
#include "core/session/truth_shares.h"

namespace archetype {

// What learning from so many of the shapes took.
struct SubsetMeasure {
  std::size_t shapes = 0;
  std::size_t templates = 0;    // at the end
  double learning_seconds = 0;  // until the templates were there
  double fitting_seconds = 0;   // for fitting them to all of the shapes and labelling these
  std::size_t judging = 0;      // shapes that no subset holds and `accuracy` is of; 0: without ground truth
  TruthShares accuracy = {};
  GroundTruthFolders truth = {};  // that was to judge by
  friend bool operator==(const SubsetMeasure&, const SubsetMeasure&) = default;
};

// About 8, 16, 32 … and all of `shapes`, but never more than a thousand: learning looks at no more than a
// hundred of them (LearnOptions::sample_size), and only the fitting afterwards would go on to grow.
std::vector<std::size_t> subset_sizes(std::size_t shapes);

// Where there is ground truth, a quarter of the shapes and a hundred at most are in no subset, and judge what
// is learned from each. With fewer than this many shapes there would be too few of both.
inline constexpr std::size_t least_shapes_to_judge = 12;

// Learns anew from random subsets of the project's shapes, the smaller ones within the larger ones; the
// project is not changed. `truth`: empty folders where none is known. Nothing if cancelled. Takes as long as
// that many learnings. The templates depend on the seed only; the times on the machine. Throws
// PreconditionError without templates or shapes.
std::optional<std::vector<SubsetMeasure>> measure_subsets(const Project& project,
                                                          const std::vector<PartTemplate>& start,
                                                          const std::vector<std::size_t>& sizes,
                                                          const GroundTruthFolders& truth, std::uint64_t seed,
                                                          unsigned threads, const JobControl& control);

// In an order that depends on the seed only: the first of them are a random subset.
std::vector<ShapeId> in_random_order(std::vector<ShapeId> shapes, std::uint64_t seed);

// The project keeps them, so that they need not be measured again to be looked at.
void store_subset_measures(Project& project, const std::vector<SubsetMeasure>& measures);
// Empty where none are stored or what is stored cannot be read.
std::vector<SubsetMeasure> stored_subset_measures(const Project& project);

}  // namespace archetype
