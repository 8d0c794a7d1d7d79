// The local shape features of section 4.1.
#pragma once

#include <span>
#include <vector>

#include "core/model/shape.h"

namespace archetype {

inline constexpr double feature_radius = 0.15;  // tau_Nhd of the paper, in units of R

// Six features of the samples within `radius` of each point, from the covariance matrix C of their positions
// with eigenvalues l1 >= l2 >= l3 and eigenvectors v1, v2, v3:
//   0: l2/l1    1: l3/l1                             how flat and how round the place is
//   2: (l1-l2)/l1 (v1.up)^2    3: (l1-l2)/l1 (v1.a2)^2   where it runs to, as far as it runs anywhere
//   4: (l2-l3)/l1 (v3.up)^2    5: (l2-l3)/l1 (v3.a2)^2   where it faces, as far as it is flat
// All lie in [0, 1].
//
// Differs from the paper: it takes acos(v1.up)/pi and so on, but the sign of an eigenvector is arbitrary, and
// v1 and v2 are not defined at all on a flat patch. Squares have no sign, and weighting by the gap between
// the eigenvalues makes every feature continuous. v3 stands for v2: the two carry the same once v1 is known,
// and v3 is defined on flat patches.
//
// a2 is x in the first array and z in the second: the template's a2 turns with the yaw, by quarter turns.
struct PointFeatures {
  std::vector<Features> x;
  std::vector<Features> z;
};
PointFeatures compute_features(std::span<const Vec3> points, double radius);

}  // namespace archetype
