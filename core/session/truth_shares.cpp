#include "core/session/truth_shares.h"

#include "core/session/evaluate_labelling.h"
#include "core/session/evaluate_landmarks.h"

namespace archetype {

namespace {

constexpr int near_step = 10;  // of ErrorCurve: 0.05

}  // namespace

std::optional<TruthShares> truth_shares(const Project& project, const GroundTruthFolders& truth,
                                        unsigned threads, const JobControl& control) {
  TruthShares shares;
  if (!truth.labels.empty()) {
    const LabellingEvaluation found = evaluate_labelling(project, truth.labels, threads, control);
    if (found.cancelled) return std::nullopt;
    if (!found.report.shapes.empty()) {
      shares.labelling = found.report.mean.own.by_area;
      shares.best_labelling = found.report.mean.best.by_area;
    }
  }
  if (!truth.landmarks.empty()) {
    const LandmarkEvaluation found = evaluate_landmarks(project, truth.landmarks, threads, control);
    if (found.cancelled) return std::nullopt;
    if (found.all.by_diameter.count() > 0) shares.correspondence = found.all.by_diameter.within(near_step);
  }
  return shares;
}

}  // namespace archetype
