// Oriented boxes, and the surfaces that stand in them: the parts of a template.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>

#include "core/geometry/vector.h"

namespace archetype {

// What a box stands for: itself, or an elliptic cylinder along one of its axes or an ellipsoid of its centre,
// volume and proportions. So a round part and a straight one have the same extents. The numbers are those of
// project files.
enum class Solid : std::uint8_t { box = 0, cylinder_x = 1, cylinder_y = 2, cylinder_z = 3, ellipsoid = 4 };

struct Box {
  Vec3 centre = Vec3::Zero();
  Vec3 half_extent = Vec3::Ones();  // along the box's own axes, each > 0
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  Solid solid = Solid::box;

  // Box coordinates: each component is in [-1, 1] inside.
  Vec3 to_local(const Vec3& p) const {
    return (orientation.conjugate() * (p - centre)).cwiseQuotient(half_extent);
  }
  Vec3 to_world(const Vec3& local) const { return centre + orientation * local.cwiseProduct(half_extent); }
};

// The point on the solid that stands for a point on the surface of the box, both in box coordinates: even
// points of the one are about even on the other.
Vec3 on_solid(Solid solid, const Vec3& on_box);

// The closest point on the surface of the solid, in box coordinates; for a point inside the closest face
// counts.
Vec3 closest_on_surface(const Box& box, const Vec3& p);

// The same with nothing in box coordinates: both points from the centre of the box, along its axes. Exact for
// boxes; for round solids by Newton's method, the distance to about 1e-6 of the smallest half extent.
Vec3 closest_on_solid(Solid solid, const Vec3& half_extent, const Vec3& p);

}  // namespace archetype
