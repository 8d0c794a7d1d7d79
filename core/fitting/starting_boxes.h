// Where the boxes of a template stand when a fit begins.
#pragma once

#include <span>
#include <vector>

#include "core/geometry/box.h"
#include "core/model/part_template.h"
#include "core/model/shape_fit.h"

namespace archetype {

std::vector<Box> mean_boxes(const PartTemplate& part_template);

// The mean boxes stretched along the template's axes until they fill the bounds of the points as they fill
// their own, by a factor of 3.5 at most. Differs from the paper, which starts from the mean boxes only: those
// of a chair find no leg of a bench.
std::vector<Box> stretched_boxes(const PartTemplate& part_template, std::span<const Vec3> points);

// What stretched boxes come to has to be better than the mean boxes at the same yaw by this factor: parts
// that were moved far may stand for other things than they were made for. (Without it glasses lose 1 % of
// their labels.)
inline constexpr double stretch_handicap = 1.15;

// The mean boxes stretched and moved along the template's axes as a whole, as those of the parts that are
// present were on the way from their mean boxes to the fitted ones (least squares over both their ends along
// each axis). A part that was left out, since its mean box lay far from it, is carried to where the others
// say that it should be. fitted: one per part of the template.
std::vector<Box> carried_boxes(const PartTemplate& part_template, std::span<const FittedPart> fitted);

}  // namespace archetype
