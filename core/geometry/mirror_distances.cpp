#include "core/geometry/mirror_distances.h"

#include <cmath>

#include "core/geometry/kd_tree.h"

namespace archetype {

std::array<double, 3> mirror_distances(const std::vector<Vec3>& points) {
  const KdTree tree(points);
  std::array<double, 3> result{};
  for (int axis = 0; axis < 3; ++axis) {
    for (Vec3 p : points) {
      p[axis] = -p[axis];
      result[static_cast<std::size_t>(axis)] += std::sqrt(tree.nearest(p).squared_distance);
    }
    result[static_cast<std::size_t>(axis)] /= static_cast<double>(points.size());
  }
  return result;
}

}  // namespace archetype
