// The cost of each sample for each part: the unary terms of the labelling (section 4.1, "Optimization
// procedure").
#pragma once

#include <span>
#include <vector>

#include "core/fitting/alpha_expansion.h"
#include "core/fitting/fit_options.h"
#include "core/model/part_template.h"
#include "core/model/shape.h"

namespace archetype {

// A box made ready for many distance queries.
struct BoxDistance {
  explicit BoxDistance(const Box& box);
  // To the surface of its solid: zero on it, growing inward and outward.
  double squared(const Vec3& p) const;

  Vec3 centre;
  Vec3 half_extent;
  Solid solid;
  Mat3 to_axes;  // from the template's axes to the box's own
  bool turned;
};

// gamma E_feat of each sample for each part (samples x parts, row by row), before it is averaged over the
// samples. Differs from the paper (equation 5): the squared deviations are averaged over the features and
// squared once, and clipped at options.feature_clip, which costs as much as having no part; the print squares
// them twice and adds them up, so that with six features even a perfect match would be dearer than the null
// label.
std::vector<double> feature_costs(const PartTemplate& part_template, std::span<const Features> features,
                                  const FitOptions& options);

// E_dist^2 + gamma E_feat per sample and part with one more column for the null label, as integers.
// unit: the length that counts as a distance of 1.
void label_costs(std::span<const Vec3> points, std::span<const Box> boxes, std::span<const double> features,
                 double unit, const FitOptions& options, LabelCosts& costs);

}  // namespace archetype
