// Evenly spaced subsets of points.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/vector.h"

namespace archetype {

// Sample elimination (Yuksel 2015, "Sample Elimination for Generating Poisson Disk Sample Sets"): the
// indices, in increasing order, of `count` of the points that lie evenly over a surface of the given area (>
// 0). Returns all of them if there are no more than `count`. O(n log n); 5,000 points to 1,000 take about 10
// ms.
std::vector<std::uint32_t> eliminate_samples(std::span<const Vec3> points, std::size_t count, double area);

}  // namespace archetype
