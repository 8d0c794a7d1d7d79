// How far a shape is from being its own mirror image.
#pragma once

#include <array>
#include <vector>

#include "core/geometry/vector.h"

namespace archetype {

// By axis: the mean distance of the points, mirrored at the plane through the origin across that axis, to the
// nearest ones; in their units. For points about their centroid. About 1 ms for 1,000 points.
std::array<double, 3> mirror_distances(const std::vector<Vec3>& points);

}  // namespace archetype
