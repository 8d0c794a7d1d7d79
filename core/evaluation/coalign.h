// All shapes of a template in one space (section 5, "Deformation quality"; figure 8).
#pragma once

#include <span>
#include <vector>

#include "core/model/part_template.h"
#include "core/model/shape.h"
#include "core/model/shape_fit.h"

namespace archetype {

// The boxes that the shape itself asks for: those of the fit, deformed further by the distances between
// samples and boxes alone, for the labels as they are. Differs from the paper, which co-aligns by the boxes
// of the fit: the small spreads of learned templates hold these near the mean boxes, and what is held back is
// not taken out of the shape. Mean squared distance of samples to the nearest sample of the other shapes'
// same part, deformed over rigid:
//                                  boxes of the fit   free boxes
//   20 chairs, dining chair, fitted      0.29            0.19
//   20 chairs, dining chair, learned     0.52            0.21
//   20 planes, airliner, learned         0.38            0.16
//   96 seats, dining chair, fitted       0.15            0.09
// About 3 ms for 1,000 samples and 8 parts. `fit` is one of `samples` by `part_template`; parts that it has
// not found keep their mean boxes. Throws PreconditionError where they do not belong together.
std::vector<Box> free_boxes(const PartTemplate& part_template, const ShapeSamples& samples,
                            const ShapeFit& fit);

// How sharp a cloud is: what is left between samples and their canonical places, the points of the mean boxes
// that their matches on the fitted boxes come from. Squared distances in normalised shape units, summed over
// the samples that belong to a part.
struct Sharpness {
  double rigid = 0;     // of samples that are only turned and moved with their shape
  double deformed = 0;  // after the deformation of each part is taken out
  double between = 0;   // of what is left before and after, their dot products
  std::size_t samples = 0;

  double mean_rigid() const { return mean_at(0); }
  double mean_deformed() const { return mean_at(1); }
  // Of samples that have gone the share `blend` of their way from rigid (0) to deformed (1).
  double mean_at(double blend) const;
  Sharpness& operator+=(const Sharpness& other);
};

// One entry per sample each, in the template's frame.
struct Coaligned {
  std::vector<Vec3> rigid;  // turned and moved with the shape
  // Where each sample lies on the mean boxes of the template: the point of the mean box that its match on the
  // fitted box comes from, plus its offset from that match. As `rigid` where it belongs to no part.
  std::vector<Vec3> deformed;
  Sharpness sharpness;
};

// `boxes` stand for the fitted ones, one per part: free_boxes(), or those of the fit. Throws as above.
Coaligned coalign(const PartTemplate& part_template, const ShapeSamples& samples, const ShapeFit& fit,
                  std::span<const Box> boxes);
// Coaligned::deformed by free boxes.
std::vector<Vec3> coalign(const PartTemplate& part_template, const ShapeSamples& samples,
                          const ShapeFit& fit);

}  // namespace archetype
