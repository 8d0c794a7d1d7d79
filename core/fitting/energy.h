// The energy of a fit in its named terms (equations 1 to 7).
#pragma once

#include <span>

#include "core/fitting/alpha_expansion.h"
#include "core/fitting/deformation.h"
#include "core/model/shape_fit.h"

namespace archetype {

// What a must-exist part costs that no sample is mapped to.
// Differs from the paper: not infinite, so that fits without it can still be told apart and written to files.
inline constexpr double missing_must_exist_energy = 1000.0;

// Equation 6 for one part, without alpha. Differs from the paper: Student's t in place of a Gaussian, since a
// shape that is stretched as a whole (a bench, from a chair) moves all parts by many deviations at once.
double part_deformation(const TemplatePart& part, const Box& box, const FitOptions& options);

// What it costs that a part is there, or that it is not; without missing_must_exist_energy.
double existence_energy(const TemplatePart& part, bool present, const FitOptions& options);

// features: as feature_costs() gives them.
FitEnergy fit_energy(const MatchedShape& shape, const PartTemplate& part_template, std::span<const Box> boxes,
                     std::span<const double> features, const LabellingGraph& graph,
                     const FitOptions& options);

}  // namespace archetype
