// Weighted sample elimination with a heap whose entries are updated lazily.
#include "core/geometry/blue_noise.h"

#include <cmath>
#include <queue>

#include "core/geometry/kd_tree.h"

namespace archetype {

namespace {

// Weight of a neighbour at a squared distance, (1 - d / 2 r_max)^8 as in the paper.
double weight(double squared_distance, double reach) {
  const double t = 1.0 - std::min(std::sqrt(squared_distance) / reach, 1.0);
  const double t2 = t * t;
  const double t4 = t2 * t2;
  return t4 * t4;
}

}  // namespace

std::vector<std::uint32_t> eliminate_samples(std::span<const Vec3> points, std::size_t count, double area) {
  const std::size_t n = points.size();
  std::vector<bool> alive(n, true);
  if (n > count) {
    const double r_max = std::sqrt(area / (2.0 * std::sqrt(3.0) * static_cast<double>(count)));
    const double reach = 2.0 * r_max;
    const KdTree tree(points);
    // Neighbour lists are capped: points piled on one place (a hostile or a very uneven file) would make them
    // grow with the square of their number, and the nearest ones say enough.
    constexpr std::size_t max_neighbours = 96;
    struct Crowding {
      std::uint32_t index;
      double weight;
    };
    std::vector<Crowding> crowding;  // of all points one after the other, about 15 each
    crowding.reserve(16 * n);
    std::vector<std::size_t> begins{0};
    std::vector<double> weights(n, 0.0);
    std::vector<KdTree::Neighbour> found;
    for (std::size_t i = 0; i < n; ++i) {
      tree.within(points[i], reach, found);
      if (found.size() > max_neighbours) tree.nearest(points[i], max_neighbours, found);
      for (const auto& f : found) {
        if (f.index == i) continue;
        const double w = weight(f.squared_distance, reach);
        crowding.push_back({f.index, w});
        weights[i] += w;
      }
      begins.push_back(crowding.size());
    }
    // Most crowded first; ties go to the higher index, so that the order is the same everywhere.
    using Entry = std::pair<double, std::uint32_t>;
    std::priority_queue<Entry> heap;
    for (std::size_t i = 0; i < n; ++i) heap.emplace(weights[i], static_cast<std::uint32_t>(i));
    for (std::size_t left = n; left > count;) {
      const auto [w, i] = heap.top();
      heap.pop();
      if (!alive[i] || w != weights[i]) continue;
      alive[i] = false;
      --left;
      for (const auto& neighbour : std::span(crowding).subspan(begins[i], begins[i + 1] - begins[i])) {
        const std::uint32_t j = neighbour.index;
        if (!alive[j]) continue;
        weights[j] -= neighbour.weight;
        heap.emplace(weights[j], j);
      }
    }
  }
  std::vector<std::uint32_t> kept;
  kept.reserve(std::min(n, count));
  for (std::size_t i = 0; i < n; ++i) {
    if (alive[i]) kept.push_back(static_cast<std::uint32_t>(i));
  }
  return kept;
}

}  // namespace archetype
