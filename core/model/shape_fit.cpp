// Between the frame of a template and that of a shape.
#include "core/model/shape_fit.h"

namespace archetype {

Vec3 turn_quarters(const Vec3& p, int quarters) {
  switch (quarters & 3) {
    case 1:
      return {p.z(), p.y(), -p.x()};
    case 2:
      return {-p.x(), p.y(), -p.z()};
    case 3:
      return {-p.z(), p.y(), p.x()};
    default:
      return p;
  }
}

std::vector<Box> ShapeFit::boxes() const {
  std::vector<Box> result;
  result.reserve(parts.size());
  for (const FittedPart& part : parts) result.push_back(part.box);
  return result;
}

Vec3 ShapeFit::to_template(const Vec3& p) const {
  return turn_quarters(p, -yaw_quarters) - translation;
}
std::vector<Vec3> ShapeFit::to_template(std::span<const Vec3> points) const {
  std::vector<Vec3> result;
  result.reserve(points.size());
  for (const Vec3& p : points) result.push_back(to_template(p));
  return result;
}
Vec3 ShapeFit::to_shape(const Vec3& q) const {
  return turn_quarters(q + translation, yaw_quarters);
}

}  // namespace archetype
