// A bounding volume hierarchy over triangles: which one does a ray hit first?
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace archetype {

struct TriangleHit {
  std::uint32_t triangle = 0;
  double distance = 0;  // along the ray, in lengths of its direction
};

// Where the ray meets the triangle, from either side; exact at shared edges: a ray through one hits one of
// its triangles (Woop, Benthin and Wald 2013, watertight intersection).
std::optional<double> intersect_triangle(const glm::dvec3& origin, const glm::dvec3& direction,
                                         const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

// Does not own the corners: three per triangle, the same ones for build and every query.
class TriangleTree {
 public:
  TriangleTree() = default;
  // O(n log n); triangles with coordinates that are not finite are left out.
  explicit TriangleTree(std::span<const glm::vec3> corners);

  // The nearest hit with 0 <= distance < limit; of equal ones the lowest triangle.
  std::optional<TriangleHit> first_hit(std::span<const glm::vec3> corners, const glm::dvec3& origin,
                                       const glm::dvec3& direction,
                                       double limit = std::numeric_limits<double>::infinity()) const;

 private:
  struct Node {
    glm::vec3 low;
    glm::vec3 high;
    std::uint32_t first = 0;  // leaf: of order_; inner: the second child (the first one follows the node)
    std::uint32_t count = 0;  // of a leaf's triangles; 0 for an inner node
  };
  void build(std::span<const glm::vec3> corners, std::uint32_t first, std::uint32_t count);

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;
};

}  // namespace archetype
