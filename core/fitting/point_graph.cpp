// Weights between neighbouring samples.
#include "core/fitting/point_graph.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/geometry/features.h"
#include "core/geometry/kd_tree.h"

namespace archetype {

LabellingGraph make_point_graph(const ShapeSamples& samples, const FitOptions& options) {
  constexpr double smallest_angle = 0.05;
  const double tau = feature_radius * samples.radius;
  struct Pair {
    std::uint32_t a;
    std::uint32_t b;
    double weight;
  };
  std::vector<Pair> pairs;
  double sum = 0;
  const KdTree tree(samples.points);
  std::vector<std::vector<KdTree::Neighbour>> nearest(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    tree.nearest(samples.points[i], static_cast<std::size_t>(options.graph_neighbours) + 1, nearest[i]);
  }
  const auto knows = [&](std::uint32_t a, std::uint32_t b) {
    return std::any_of(nearest[a].begin(), nearest[a].end(), [b](const auto& n) { return n.index == b; });
  };
  for (std::uint32_t a = 0; a < samples.size(); ++a) {
    for (const auto& [b, squared] : nearest[a]) {
      if (b == a || (b < a && knows(b, a))) continue;  // once for each pair
      const double cosine = std::min(std::abs(samples.normals[a].dot(samples.normals[b])), 1.0);
      const double theta = std::max(std::acos(cosine), smallest_angle);
      const double weight = -std::log(theta / std::numbers::pi) * std::exp(-squared / (tau * tau));
      pairs.push_back({a, b, weight});
      sum += 2 * weight;
    }
  }
  const double scale =
      sum > 0 ? options.beta * label_cost_scale * static_cast<double>(samples.size()) / sum : 0.0;
  std::vector<GraphEdge> edges;
  for (const Pair& p : pairs) {
    const auto weight = static_cast<std::int32_t>(std::lround(p.weight * scale));
    if (weight > 0) edges.push_back({p.a, p.b, weight});
  }
  return make_labelling_graph(samples.size(), edges);
}

}  // namespace archetype
