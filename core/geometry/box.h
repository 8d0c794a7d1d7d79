// Oriented boxes: the parts of a template.
#pragma once

#include <Eigen/Geometry>

#include "core/geometry/vector.h"

namespace archetype {

struct Box {
  Vec3 centre = Vec3::Zero();
  Vec3 half_extent = Vec3::Ones();  // along the box's own axes, each > 0
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();

  // Box coordinates: each component is in [-1, 1] inside.
  Vec3 to_local(const Vec3& p) const {
    return (orientation.conjugate() * (p - centre)).cwiseQuotient(half_extent);
  }
  Vec3 to_world(const Vec3& local) const { return centre + orientation * local.cwiseProduct(half_extent); }
};

// The closest point on the surface of the box, in box coordinates; for a point inside the closest face
// counts.
Vec3 closest_on_surface(const Box& box, const Vec3& p);

}  // namespace archetype
