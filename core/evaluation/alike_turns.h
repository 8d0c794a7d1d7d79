// The turns about up by which a shape comes to lie on itself.
#pragma once

#include <vector>

#include "core/geometry/surface_search.h"
#include "core/model/shape.h"

namespace archetype {

// Turns are counted in steps of 15 degrees.
inline constexpr int turn_steps = 24;

// By `steps` of these about the vertical axis through the centroid; both points in file coordinates.
Vec3 turn_about_up(const ShapeFrame& frame, const Vec3& p, int steps);

// Those by which nineteen of twenty samples come to lie within 2 % of R of the surface: all for a lamp that
// is a surface of revolution, every sixth for a square table; always 0, first. `surface`: in file
// coordinates. Where there are several, nobody can tell which side is the front. About 1 ms for a shape
// without any, 20 ms with all.
std::vector<int> alike_turns(const ShapeSamples& samples, const SurfaceSearch& surface);

}  // namespace archetype
