// Left and right: shapes and templates that are their own mirror images.
#pragma once

#include <array>
#include <span>

#include "core/model/part_template.h"
#include "core/model/shape.h"

namespace archetype {

// Whether the planes through the centroid across x (entry 0) and across z (entry 1) mirror the shape onto
// itself: the mirrored samples lie as near to the samples as samples lie to each other, almost. O(n log n).
std::array<bool, 2> mirror_planes(const ShapeSamples& samples);

// The mirror image across x (axis 0) or z (axis 2).
Box mirrored(const Box& box, int axis);

// The same box with its own axes called after those of the template that they are nearest to, as a quarter
// turn of a box calls for: boxes that are alike have means and extents that are alike.
Box with_nearest_axes(const Box& box);

// How far apart the corners of two boxes lie, about: the square root of the squared distance of the centres
// and of the half axes.
double box_distance(const Box& a, const Box& b);

// Makes parts that are nearly each other's mirror image exactly so, in means and deviations alike, and parts
// that are nearly their own.
void mirror_parts(PartTemplate& part_template, int axis);

}  // namespace archetype
