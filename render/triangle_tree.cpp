// A bounding volume hierarchy over triangles, split at the median of the longest side.
#include "render/triangle_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>

namespace archetype {
namespace {

constexpr std::uint32_t leaf_size = 4;

bool finite(const glm::vec3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

// Slabs; a ray within a side of the box counts as a hit. Widened a little, so that rounding cannot lose a
// flat box.
bool meets(const glm::vec3& low, const glm::vec3& high, const glm::dvec3& origin, const glm::dvec3& direction,
           double limit) {
  double enter = 0;
  double leave = limit;
  for (int k = 0; k < 3; ++k) {
    const double margin =
        1e-6 * (std::abs(static_cast<double>(low[k])) + std::abs(static_cast<double>(high[k])));
    const double below = low[k] - margin - origin[k];
    const double above = high[k] + margin - origin[k];
    if (direction[k] == 0) {
      if (below > 0 || above < 0) return false;
      continue;
    }
    const double a = below / direction[k];
    const double b = above / direction[k];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter <= leave;
}

}  // namespace

std::optional<double> intersect_triangle(const glm::dvec3& origin, const glm::dvec3& direction,
                                         const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  // Sheared into coordinates in which the ray runs along +z through the origin, its longest component being
  // z.
  int z = 0;
  for (int k = 1; k < 3; ++k)
    if (std::abs(direction[k]) > std::abs(direction[z])) z = k;
  const int x = (z + 1) % 3;
  const int y = (z + 2) % 3;
  const double shear_x = direction[x] / direction[z];
  const double shear_y = direction[y] / direction[z];
  const auto shear = [&](const glm::dvec3& p) {
    const glm::dvec3 d = p - origin;
    return glm::dvec3(d[x] - shear_x * d[z], d[y] - shear_y * d[z], d[z] / direction[z]);
  };
  const std::array<glm::dvec3, 3> p{shear(a), shear(b), shear(c)};
  const double u = p[2].x * p[1].y - p[2].y * p[1].x;
  const double v = p[0].x * p[2].y - p[0].y * p[2].x;
  const double w = p[1].x * p[0].y - p[1].y * p[0].x;
  if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return std::nullopt;
  const double area = u + v + w;
  if (area == 0) return std::nullopt;
  return (u * p[0].z + v * p[1].z + w * p[2].z) / area;
}

TriangleTree::TriangleTree(std::span<const glm::vec3> corners) {
  const auto triangle_count = static_cast<std::uint32_t>(corners.size() / 3);
  order_.reserve(triangle_count);
  for (std::uint32_t t = 0; t < triangle_count; ++t)
    if (finite(corners[3 * t]) && finite(corners[3 * t + 1]) && finite(corners[3 * t + 2]))
      order_.push_back(t);
  nodes_.reserve(order_.size());
  if (!order_.empty()) build(corners, 0, static_cast<std::uint32_t>(order_.size()));
}

void TriangleTree::build(std::span<const glm::vec3> corners, std::uint32_t first, std::uint32_t count) {
  glm::vec3 low(std::numeric_limits<float>::max());
  glm::vec3 high(std::numeric_limits<float>::lowest());
  for (std::uint32_t i = first; i < first + count; ++i)
    for (std::uint32_t k = 0; k < 3; ++k) {
      low = glm::min(low, corners[3 * order_[i] + k]);
      high = glm::max(high, corners[3 * order_[i] + k]);
    }
  const std::size_t node = nodes_.size();
  nodes_.push_back({low, high, first, count});
  if (count <= leaf_size) return;

  const glm::vec3 size = high - low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  // Ties by number: the tree, and so the answer for equal distances, is the same everywhere.
  const auto before = [&](std::uint32_t s, std::uint32_t t) {
    const float a = corners[3 * s][axis] + corners[3 * s + 1][axis] + corners[3 * s + 2][axis];
    const float b = corners[3 * t][axis] + corners[3 * t + 1][axis] + corners[3 * t + 2][axis];
    return a != b ? a < b : s < t;
  };
  const std::uint32_t half = count / 2;
  std::nth_element(order_.begin() + first, order_.begin() + first + half, order_.begin() + first + count,
                   before);
  build(corners, first, half);
  nodes_[node].first = static_cast<std::uint32_t>(nodes_.size());
  nodes_[node].count = 0;
  build(corners, first + half, count - half);
}

std::optional<TriangleHit> TriangleTree::first_hit(std::span<const glm::vec3> corners,
                                                   const glm::dvec3& origin, const glm::dvec3& direction,
                                                   double limit) const {
  std::optional<TriangleHit> best;
  if (nodes_.empty()) return best;
  std::vector<std::uint32_t> open{0};
  while (!open.empty()) {
    const std::uint32_t index = open.back();
    const Node& node = nodes_[index];
    open.pop_back();
    if (!meets(node.low, node.high, origin, direction, best ? best->distance : limit)) continue;
    if (node.count == 0) {
      open.push_back(node.first);
      open.push_back(index + 1);
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const std::uint32_t t = order_[i];
      const auto distance =
          intersect_triangle(origin, direction, corners[3 * t], corners[3 * t + 1], corners[3 * t + 2]);
      if (!distance || *distance < 0 || *distance >= limit) continue;
      if (!best || *distance < best->distance || (*distance == best->distance && t < best->triangle))
        best = TriangleHit{t, *distance};
    }
  }
  return best;
}

}  // namespace archetype
