// The orientation of a box as three angles that people type.
#pragma once

#include <Eigen/Geometry>

#include "core/geometry/vector.h"

namespace archetype {

// Turns about x, then y, then z of the template's own axes, in degrees.
Eigen::Quaterniond orientation_of_degrees(const Vec3& degrees);
// The angles that give the orientation; y in [-90, 90], where it is ±90 z is 0.
Vec3 degrees_of_orientation(const Eigen::Quaterniond& orientation);

}  // namespace archetype
