// A shape as the method sees it: a set of points sampled on its surface.
#pragma once

#include <array>
#include <cstdint>

#include "core/geometry/shape_frame.h"
#include "core/geometry/vector.h"

namespace archetype {

inline constexpr int feature_count = 6;
using Features =
    std::array<double, feature_count>;  // section 4.1; see geometry/features.h for each one's meaning

// Everything about a shape that fitting needs, in normalised coordinates (see ShapeFrame). All arrays have
// one entry per sample.
struct ShapeSamples {
  ShapeFrame frame;
  double radius = 0;          // R: the largest distance between two samples, in normalised units
  std::vector<Vec3> points;   // even over the surface (blue noise)
  std::vector<Vec3> normals;  // unit, unsigned: their sign has no meaning
  std::vector<std::uint32_t>
      faces;  // the face of the file each lies on; the point of the file for point sets
  // Local shape about each sample with a2 along x (yaws of 0 and 180 degrees) and along z (90 and 270
  // degrees).
  std::vector<Features> features_x;
  std::vector<Features> features_z;

  std::size_t size() const { return points.size(); }
};

}  // namespace archetype
