// New template parameters from the fits of the learning set ("Template refinement" of section 4.2).
#pragma once

#include <span>
#include <vector>

#include "core/learning/learn_options.h"
#include "core/model/part_template.h"
#include "core/model/shape.h"
#include "core/model/shape_fit.h"

namespace archetype {

// What one shape says of one part: all that re-estimation needs of a fit.
struct PartObservation {
  bool present = false;
  Box box;  // in the template's frame
  std::size_t samples = 0;
  Features feature_sum{};     // over the samples of the part
  Features feature_square{};  // their squares
};

// One per part of the template that was fitted.
std::vector<PartObservation> observe_parts(const ShapeFit& fit, const ShapeSamples& samples);

// The template whose means, spreads, axes, features and existence are those of `observed` (one entry per
// shape, each with one observation per part), shrunk towards `initial`, what was known before: its means
// count as options.prior_shapes_of_means shapes, its spreads as options.prior_shapes_of_spreads, after the
// prior variances of all parts were multiplied by one factor for positions and one for sizes, which the
// shapes tell (at least options.smallest_spread_factor, at most 1). No spread is less than
// options.smallest_spread. Differs from the paper, which has no
// prior: a spread of five shapes may be anything. Both have the same parts; names, labels and must_exist are
// kept. Parts that no shape has keep their means.
PartTemplate reestimate(const PartTemplate& initial, std::span<const std::vector<PartObservation>> observed,
                        const LearnOptions& options);

}  // namespace archetype
