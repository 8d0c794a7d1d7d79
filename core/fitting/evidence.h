// Whether a shape has a part, or the part only holds samples that others would hold as well.
#pragma once

#include <span>
#include <vector>

#include "core/fitting/deformation.h"
#include "core/fitting/label_costs.h"

namespace archetype {

// For each part, in squared distance units: what one of its samples gains by it on average (its cost with the
// label that is next best, less its cost), less the mean squared distance of the part's template samples to
// their matches, plus options.odds_weight times the logarithm of the odds of its existence. Below zero the
// part is better left out. Infinite for parts without samples and for those that must exist.
// Differs from the paper, which lets the labelling alone decide which parts there are: it takes a part where
// it finds samples that cost a little less with it, though most of its box is empty, so that every optional
// part takes samples of its neighbours on all the shapes that lack it. Means and not sums, so that a small
// part counts as much as a large one.
// costs: of all samples, as label_costs() gives them for these boxes.
std::vector<double> part_evidence(const MatchedShape& shape, const PartTemplate& part_template,
                                  std::span<const Box> boxes, const LabelCosts& costs,
                                  const FitOptions& options);

}  // namespace archetype
