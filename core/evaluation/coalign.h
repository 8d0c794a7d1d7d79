// All shapes of a template in one space (section 5, "Deformation quality").
#pragma once

#include <vector>

#include "core/model/part_template.h"
#include "core/model/shape.h"
#include "core/model/shape_fit.h"

namespace archetype {

// Where each sample lies on the mean boxes of the template: the point of the mean box that its match on the
// fitted box comes from, plus its offset from that match. Samples that belong to no part are only turned and
// moved with the shape. `fit` is one of `samples` by `part_template`. One entry per sample.
std::vector<Vec3> coalign(const PartTemplate& part_template, const ShapeSamples& samples,
                          const ShapeFit& fit);

}  // namespace archetype
