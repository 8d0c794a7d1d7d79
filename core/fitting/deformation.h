// The third and fourth step of the alternation: where the template stands, and how its boxes deform.
#pragma once

#include <span>
#include <vector>

#include "core/fitting/correspondence.h"
#include "core/fitting/fit_options.h"
#include "core/model/part_template.h"

namespace archetype {

// What one alternation works on; everything in the template's frame.
struct MatchedShape {
  std::span<const Vec3> points;
  std::span<const std::int16_t> labels;
  const TemplateSurface* surface;
  const Correspondences* matches;
  double unit;  // the length that counts as a distance of 1
};

// The translation by which the shape has to move, so that the squared distances of all correspondences, both
// ways, are least. The yaw stays that of the start. Differs from the paper, which says both that r is fixed
// for each start and that it is solved for by SVD: a free rotation was measured to gain nothing on upright
// shapes.
Vec3 rigid_step(const MatchedShape& shape, std::span<const Box> boxes);

// Of a fitted box along any of its axes, normalised units.
inline constexpr double smallest_half_extent = 0.01;

// The rotation as axis times angle (at most pi), in radians.
Vec3 turn_vector(const Eigen::Quaterniond& turn);
// Its inverse.
Eigen::Quaterniond turn_rotation(const Vec3& vector);

// The boxes that minimise E_data + alpha E_deform for given labels and correspondences. Derivation: the
// target of a correspondence at box coordinate u on one axis is x = b_p + u b_s. With w = 1 / (|P_s| unit^2)
// for pairs from the shape and 1 / (|P_t| unit^2) for pairs from the template, setting both derivatives to
// zero gives, per part and axis,
//   [sum w + alpha/sp^2,  sum w u           ] [b_p]   [sum w x   + alpha mp/sp^2]
//   [sum w u,             sum w u^2 + alpha/ss^2] [b_s] = [sum w x u + alpha ms/ss^2].
// Boxes that are turned work in their own axes, where the position's variance is projected onto each axis.
// After that each box turns about its centre: legs splay, wings are swept, handles lean.
// Differs from the paper, whose boxes keep the template's axes.
// Parts without samples keep their mean box. Half extents stay above smallest_half_extent.
void deformation_step(const MatchedShape& shape, const PartTemplate& part_template, const FitOptions& options,
                      std::span<Box> boxes);

}  // namespace archetype
