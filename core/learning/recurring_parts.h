// Parts that one shape does not have, from the segmentations of many shapes.
#pragma once

#include <span>

#include "core/base/job_control.h"
#include "core/learning/segment_shape.h"
#include "core/model/part_template.h"
#include "core/model/shape_fit.h"

namespace archetype {

// A shape's own boxes, and its fit by the template that they are brought to.
struct AlignedSegmentation {
  const Segmentation* segmentation;
  const ShapeFit* fit;
};

// Of the shapes; what is rarer is no part of the collection but of a shape.
inline constexpr double smallest_recurrence = 0.15;

// The parts that recur in the shapes though the template lacks them: boxes of different shapes, one of each
// at most, that are near to each other in place and extent once they stand in the template's frame, and near
// to no part of their shape's fit. The part of the most shapes comes first; its existence is the share of the
// shapes that have such a box, its mean and deviations are those of the boxes. O(parts x boxes squared).
// Nothing if cancelled.
//
// Differs from the paper, where the first template has to hold all parts: no single shape has to have them
// all here.
std::vector<TemplatePart> recurring_parts(std::span<const AlignedSegmentation> shapes,
                                          const JobControl& control = {});

}  // namespace archetype
