// Split at the median of the longest side; searched from the nearer child.
#include "core/geometry/surface_search.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "core/base/error.h"

namespace archetype {

namespace {

constexpr std::uint32_t leaf_size = 4;

double squared_distance(const Bounds& bounds, const Vec3& p) {
  return (p - p.cwiseMax(bounds.low).cwiseMin(bounds.high)).squaredNorm();
}

// The nearest point of a side, corner `a` having the weight 1 - t and corner `b` the weight t.
SurfacePoint closest_on_side(const Triangle& triangle, int a, int b, const Vec3& p) {
  const auto& from = triangle[static_cast<std::size_t>(a)];
  const Vec3 along = triangle[static_cast<std::size_t>(b)] - from;
  const double length = along.squaredNorm();
  const double t = length > 0 ? std::clamp(along.dot(p - from) / length, 0.0, 1.0) : 0.0;
  SurfacePoint point;
  point.weights[a] = 1 - t;
  point.weights[b] = t;
  point.squared_distance = (from + t * along - p).squaredNorm();
  return point;
}

}  // namespace

SurfacePoint closest_on_triangle(const Triangle& triangle, const Vec3& p) {
  const Vec3 u = triangle[1] - triangle[0];
  const Vec3 v = triangle[2] - triangle[0];
  const Vec3 normal = u.cross(v);
  const double area = normal.squaredNorm();
  // Thinner ones are as good as their sides.
  if (area > 1e-20 * u.squaredNorm() * v.squaredNorm()) {
    const Vec3 d = p - triangle[0];
    const double b = d.cross(v).dot(normal) / area;
    const double c = u.cross(d).dot(normal) / area;
    if (b >= 0 && c >= 0 && b + c <= 1) {
      const double height = d.dot(normal);
      return {0, {1 - b - c, b, c}, height * height / area};
    }
  }
  SurfacePoint best = closest_on_side(triangle, 0, 1, p);
  for (const auto& [a, b] : {std::pair(1, 2), std::pair(2, 0)}) {
    const SurfacePoint side = closest_on_side(triangle, a, b, p);
    if (side.squared_distance < best.squared_distance) best = side;
  }
  return best;
}

SurfaceSearch::SurfaceSearch(std::vector<Triangle> triangles) : triangles_(std::move(triangles)) {
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    if (std::ranges::all_of(triangles_[t], [](const Vec3& p) { return p.allFinite(); })) order_.push_back(t);
  }
  nodes_.reserve(order_.size());
  if (!order_.empty()) build(0, static_cast<std::uint32_t>(order_.size()));
}

void SurfaceSearch::build(std::uint32_t first, std::uint32_t count) {
  Bounds bounds;
  for (std::uint32_t i = first; i < first + count; ++i) {
    for (const Vec3& corner : triangles_[order_[i]]) bounds.add(corner);
  }
  const std::size_t node = nodes_.size();
  nodes_.push_back({bounds, first, count});
  if (count <= leaf_size) return;
  Eigen::Index axis = 0;
  (bounds.high - bounds.low).maxCoeff(&axis);
  const auto place = [&](std::uint32_t t) {
    return triangles_[t][0][axis] + triangles_[t][1][axis] + triangles_[t][2][axis];
  };
  const std::uint32_t half = count / 2;
  const auto begin = order_.begin() + first;
  std::nth_element(begin, begin + half, begin + count, [&](std::uint32_t s, std::uint32_t t) {
    const double a = place(s);
    const double b = place(t);
    return a != b ? a < b : s < t;
  });
  build(first, half);
  nodes_[node].first = static_cast<std::uint32_t>(nodes_.size());
  nodes_[node].count = 0;
  build(first + half, count - half);
}

SurfacePoint SurfaceSearch::nearest(const Vec3& p) const {
  if (empty()) throw PreconditionError("there is no surface to search");
  SurfacePoint best;
  best.squared_distance = std::numeric_limits<double>::infinity();
  std::vector<std::uint32_t> open{0};
  while (!open.empty()) {
    const std::uint32_t index = open.back();
    open.pop_back();
    const Node& node = nodes_[index];
    if (squared_distance(node.bounds, p) > best.squared_distance) continue;
    if (node.count == 0) {
      std::uint32_t near = index + 1;
      std::uint32_t far = node.first;
      if (squared_distance(nodes_[far].bounds, p) < squared_distance(nodes_[near].bounds, p))
        std::swap(near, far);
      open.push_back(far);
      open.push_back(near);
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      SurfacePoint point = closest_on_triangle(triangles_[order_[i]], p);
      point.triangle = order_[i];
      if (point.squared_distance < best.squared_distance ||
          (point.squared_distance == best.squared_distance && point.triangle < best.triangle))
        best = point;
    }
  }
  return best;
}

}  // namespace archetype
