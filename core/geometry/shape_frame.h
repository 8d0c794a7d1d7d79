// From the coordinates of a file to those of the normalised shape, and back.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/geometry/vector.h"

namespace archetype {

// The axis of the file that points up in the real object.
enum class UpAxis { y, z, x, minus_y, minus_z, minus_x };

std::string_view to_string(UpAxis up);                       // "y", "-z", …
std::optional<UpAxis> parse_up_axis(std::string_view text);  // nothing for any other text
Mat3 upright_rotation(UpAxis up);  // a rotation by quarter turns that takes `up` to +y

// Section 5: the centroid of the surface samples lies at the origin, their mean distance to it is 1, up is
// +y. normalised = scale * (rotation * file - centroid).
struct ShapeFrame {
  Mat3 rotation = Mat3::Identity();
  Vec3 centroid = Vec3::Zero();  // after the rotation, in file units
  double scale = 1.0;

  Vec3 to_normalised(const Vec3& file) const { return scale * (rotation * file - centroid); }
  Vec3 to_file(const Vec3& normalised) const {
    return rotation.transpose() * (normalised / scale + centroid);
  }
};

}  // namespace archetype
