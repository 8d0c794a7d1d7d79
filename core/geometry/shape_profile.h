// How a shape is spread about its vertical axis.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "core/geometry/vector.h"

namespace archetype {

// Quantiles of the samples' heights, then of their distances from the vertical axis, then the mean such
// distance in layers of equally many samples from bottom to top: the same for every yaw. Quantiles, since
// differences of histograms favour whichever axis blurs the shape most.
inline constexpr std::size_t profile_quantiles = 16;
using ShapeProfile = std::array<float, 3 * profile_quantiles>;

// points: y up, about the vertical axis through the origin; any number from one on.
ShapeProfile shape_profile(std::span<const Vec3> points);

}  // namespace archetype
