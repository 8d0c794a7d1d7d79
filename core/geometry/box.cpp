// The closest point on a box is analytic, so that labelling needs no samples of the template.
#include "core/geometry/box.h"

namespace archetype {

Vec3 closest_on_surface(const Box& box, const Vec3& p) {
  const Vec3 local = box.to_local(p);
  Vec3 closest = local.cwiseMax(-1.0).cwiseMin(1.0);
  if (closest != local) return closest;
  // Inside: push out through the face that is nearest in shape units, not in box coordinates.
  int axis = 0;
  ((Vec3::Ones() - local.cwiseAbs()).cwiseProduct(box.half_extent)).minCoeff(&axis);
  closest[axis] = local[axis] < 0 ? -1.0 : 1.0;
  return closest;
}

}  // namespace archetype
