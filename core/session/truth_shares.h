// How well the fits of a project agree with ground truth, in one number each.
#pragma once

#include <optional>

#include "core/base/job_control.h"
#include "core/session/ground_truth.h"

namespace archetype {

// From 0 to 1; nothing where there is no truth for any shape.
struct TruthShares {
  std::optional<double> labelling;       // of the area that has its true label, mean over the shapes
  std::optional<double> best_labelling;  // the same, with the best assignment of labels to parts
  std::optional<double> correspondence;  // of the landmarks that come within 0.05 of the diameter
  friend bool operator==(const TruthShares&, const TruthShares&) = default;
};

// Costs what evaluate_labelling() and evaluate_landmarks() do. Nothing if cancelled. Files that cannot be
// used are left out.
std::optional<TruthShares> truth_shares(const Project& project, const GroundTruthFolders& truth,
                                        unsigned threads, const JobControl& control);

}  // namespace archetype
