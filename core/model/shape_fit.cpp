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

Vec3 ShapeFit::to_template(const Vec3& p) const {
  return turn_quarters(p, -yaw_quarters) - translation;
}
Vec3 ShapeFit::to_shape(const Vec3& q) const {
  return turn_quarters(q + translation, yaw_quarters);
}

}  // namespace archetype
