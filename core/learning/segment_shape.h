// Segments one shape into boxes, or round parts as well, without knowing anything of its kind (section 4.3,
// "Automatic shape segmentations").
#pragma once

#include <optional>
#include <vector>

#include "core/base/job_control.h"
#include "core/geometry/box.h"
#include "core/learning/region_box.h"
#include "core/model/shape.h"

namespace archetype {

struct SegmentationOptions {
  int min_parts = 2;  // at least 1
  int max_parts = 12;
  std::uint64_t seed = 1;
  // What one more part has to save: the mean over the samples of the squared distances between shape and
  // boxes, both ways, in the unit of the fits (0.1 R).
  double part_cost = 0.01;
  // With round ones a vase's body is one part, not a dozen staves; but an aeroplane's tail may go with it.
  RegionSolids solids = RegionSolids::boxes;
};

struct Segmentation {
  std::vector<Box> boxes;            // in the frame of the shape, the one with the most samples first
  std::vector<std::int16_t> labels;  // one per sample: the box it belongs to
  double cost = 0;                   // the criterion: mean squared distances + part_cost x parts
};

// Regions about points that are as far apart as can be take the samples that fit their boxes best
// (fitting/), and are joined, two at a time, as long as boxes stand for the shape about as well. The number
// of boxes is the one in the range with the least cost. Fewer than min_parts come out only of a shape of
// fewer samples. Deterministic; about 0.2 s for 1,000 samples, up to five times as long with round parts.
// Nothing when cancelled.
//
// Differs from the paper, whose number of clusters is given once for all (N_seg, not printed): a vase and an
// aeroplane do not have the same number of parts, and what farthest points cut apart is one part as often as
// not.
std::optional<Segmentation> segment_shape(const ShapeSamples& samples, const SegmentationOptions& options,
                                          const JobControl& control = {});

}  // namespace archetype
