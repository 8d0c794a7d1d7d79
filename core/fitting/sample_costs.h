// How well a fit explains each sample of its shape.
#pragma once

#include <vector>

#include "core/fitting/fit_options.h"
#include "core/model/part_template.h"
#include "core/model/shape.h"
#include "core/model/shape_fit.h"

namespace archetype {

// E_dist^2 + gamma E_feat of each sample with its label (equations 3 and 5): 0 is perfect, 1 as far from its
// part as one distance unit; options.null_cost where it has no label. The samples have to be those that were
// fitted.
std::vector<double> sample_costs(const PartTemplate& part_template, const ShapeSamples& samples,
                                 const ShapeFit& fit, const FitOptions& options);

}  // namespace archetype
