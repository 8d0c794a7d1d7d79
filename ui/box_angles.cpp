#include "ui/box_angles.h"

#include <cmath>
#include <numbers>

namespace archetype {
namespace {

constexpr double degree = std::numbers::pi / 180;

}  // namespace

Eigen::Quaterniond orientation_of_degrees(const Vec3& degrees) {
  return Eigen::AngleAxisd(degrees.z() * degree, Vec3::UnitZ()) *
         Eigen::AngleAxisd(degrees.y() * degree, Vec3::UnitY()) *
         Eigen::AngleAxisd(degrees.x() * degree, Vec3::UnitX());
}

// R = Rz Ry Rx has -sin y in its lower left corner, cos y (cos z, sin z) above it and cos y (sin x, cos x)
// beside it.
Vec3 degrees_of_orientation(const Eigen::Quaterniond& orientation) {
  const Mat3 r = orientation.toRotationMatrix();
  const double cos_y = std::hypot(r(0, 0), r(1, 0));
  Vec3 angles;
  angles.y() = std::atan2(-r(2, 0), cos_y);
  if (cos_y > 1e-9) {
    angles.x() = std::atan2(r(2, 1), r(2, 2));
    angles.z() = std::atan2(r(1, 0), r(0, 0));
  } else {
    angles.x() = std::atan2(-r(1, 2), r(1, 1));  // only x ∓ z is known; z = 0
    angles.z() = 0;
  }
  return angles / degree + Vec3::Zero();  // no -0
}

}  // namespace archetype
