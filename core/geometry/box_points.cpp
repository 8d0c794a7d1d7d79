#include "core/geometry/box_points.h"

namespace archetype {
namespace {

Box box_of(const Bounds& bounds, const Eigen::Quaterniond& orientation) {
  return {orientation * bounds.centre(), bounds.half_extent(), orientation};
}

}  // namespace

Box grown_to(const Box& box, std::span<const Vec3> points) {
  Bounds bounds;
  const Vec3 centre = box.orientation.conjugate() * box.centre;
  bounds.add(centre - box.half_extent);
  bounds.add(centre + box.half_extent);
  for (const Vec3& point : points) bounds.add(box.orientation.conjugate() * point);
  return box_of(bounds, box.orientation);
}

Box shrunk_to(const Box& box, std::span<const Vec3> points, double margin) {
  Bounds bounds;
  for (const Vec3& point : points)
    if (box.to_local(point).cwiseAbs().maxCoeff() <= 1 + margin)
      bounds.add(box.orientation.conjugate() * point);
  return bounds.empty() ? box : box_of(bounds, box.orientation);
}

Box box_around(std::span<const Vec3> points, const Eigen::Quaterniond& orientation) {
  Bounds bounds;
  for (const Vec3& point : points) bounds.add(orientation.conjugate() * point);
  return box_of(bounds, orientation);
}

}  // namespace archetype
