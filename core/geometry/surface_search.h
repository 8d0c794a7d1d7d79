// The point of a surface that is nearest to another point, exactly.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/geometry/vector.h"

namespace archetype {

using Triangle = std::array<Vec3, 3>;  // corners; may have no area: a segment or a point

struct SurfacePoint {
  std::uint32_t triangle = 0;
  Vec3 weights = Vec3::Zero();  // of the corners; not below 0, together 1
  double squared_distance = 0;
};

SurfacePoint closest_on_triangle(const Triangle& triangle, const Vec3& p);

// A bounding volume hierarchy over triangles. O(n log n) to make, about O(log n) a query.
class SurfaceSearch {
 public:
  SurfaceSearch() = default;
  // Triangles with coordinates that are not finite are never found.
  explicit SurfaceSearch(std::vector<Triangle> triangles);

  bool empty() const { return nodes_.empty(); }
  // Of equally near triangles the first. The search must not be empty.
  SurfacePoint nearest(const Vec3& p) const;

 private:
  struct Node {
    Bounds bounds;
    std::uint32_t first = 0;  // leaf: of order_; inner: the second child (the first one follows the node)
    std::uint32_t count = 0;  // of a leaf's triangles; 0 for an inner node
  };
  void build(std::uint32_t first, std::uint32_t count);

  std::vector<Triangle> triangles_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;
};

}  // namespace archetype
