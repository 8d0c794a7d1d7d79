// A box or a round solid for a region of a shape's surface, and how badly it stands for it.
#pragma once

#include <span>

#include "core/geometry/box.h"

namespace archetype {

enum class RegionSolids {
  boxes,
  any  // round ones, too
};

struct RegionBox {
  Box box;
  double cost = 0;  // see fit_region_box()
};

// The box of the points that costs least, or where `solids` has them one that stands for a round solid
// (Solid) if that is clearly better: along the axes of the shape, or along the principal axes of the points
// where that is clearly better. The cost of a box is the sum of the squared distances of the points to its
// surface and of even samples of its surface to the points, in units of `unit`, both as dense as one sample
// in a square of side `spacing`: a part's surface that its box does not show costs as much as a surface of
// the box that the part does not have. Needs a point. O(n log n); 1,000 points take about 1 ms, five times as
// long with round solids.
//
// Differs from the paper, which takes principal axes always and a standard deviation for the half extents:
// the principal axes of a square seat or of a vase are arbitrary, and the fit would have to find the extents
// again.
RegionBox fit_region_box(std::span<const Vec3> points, double unit, double spacing, RegionSolids solids);

}  // namespace archetype
