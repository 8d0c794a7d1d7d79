// Boxes that are fitted by hand to points of a surface.
#pragma once

#include <span>

#include "core/geometry/box.h"

namespace archetype {

// The smallest box along the same axes that holds the box and all points.
Box grown_to(const Box& box, std::span<const Vec3> points);

// The smallest box along the same axes that holds those of the points that lie in the box, or up to `margin`
// of its half extents outside. The box itself where there are none. Half extents may become 0.
Box shrunk_to(const Box& box, std::span<const Vec3> points, double margin = 0.02);

// Around the points, along the axes of `orientation`. Needs a point.
Box box_around(std::span<const Vec3> points, const Eigen::Quaterniond& orientation);

}  // namespace archetype
