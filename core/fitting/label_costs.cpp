// Distances to boxes and to feature means.
#include "core/fitting/label_costs.h"

#include <algorithm>
#include <cmath>

#include "core/fitting/point_graph.h"

namespace archetype {

BoxDistance::BoxDistance(const Box& box)
    : centre(box.centre),
      half_extent(box.half_extent),
      solid(box.solid),
      to_axes(box.orientation.conjugate().toRotationMatrix()),
      turned(!to_axes.isIdentity(1e-12)) {}

double BoxDistance::squared(const Vec3& p) const {
  Vec3 d = p - centre;
  if (turned) d = to_axes * d;
  if (solid != Solid::box) return (closest_on_solid(solid, half_extent, d) - d).squaredNorm();
  const Vec3 beyond = d.cwiseAbs() - half_extent;
  const double inside = beyond.maxCoeff();
  return inside < 0 ? inside * inside : beyond.cwiseMax(0.0).squaredNorm();
}

std::vector<double> feature_costs(const PartTemplate& part_template, std::span<const Features> features,
                                  const FitOptions& options) {
  const std::size_t parts = part_template.parts.size();
  std::vector<double> costs(features.size() * parts, 0.0);
  for (std::size_t k = 0; k < parts; ++k) {
    const FeatureGaussian& expected = part_template.parts[k].features;
    Features inverse{};
    for (std::size_t f = 0; f < inverse.size(); ++f) inverse[f] = 1.0 / expected.stddev[f];
    for (std::size_t i = 0; i < features.size(); ++i) {
      double sum = 0;
      for (std::size_t f = 0; f < inverse.size(); ++f) {
        const double deviation = (features[i][f] - expected.mean[f]) * inverse[f];
        sum += deviation * deviation;
      }
      const double mean = sum / static_cast<double>(inverse.size());
      costs[i * parts + k] = options.gamma * std::min(mean / options.feature_clip, 1.0);
    }
  }
  return costs;
}

void label_costs(std::span<const Vec3> points, std::span<const Box> boxes, std::span<const double> features,
                 double unit, const FitOptions& options, LabelCosts& costs) {
  // Far from every box all labels are hopeless alike; the bound keeps sums of costs within an integer.
  constexpr double largest = 10000.0;
  const std::size_t parts = boxes.size();
  const double scale = label_cost_scale / (unit * unit);
  costs.resize(points.size() * (parts + 1));
  for (std::size_t k = 0; k < parts; ++k) {
    const BoxDistance distance(boxes[k]);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double cost = scale * distance.squared(points[i]) + label_cost_scale * features[i * parts + k];
      // A cost is never negative, and std::lround would be a call for each.
      costs[i * (parts + 1) + k] =  // NOLINTNEXTLINE(bugprone-incorrect-roundings)
          static_cast<std::int32_t>(std::min(cost, largest * label_cost_scale) + 0.5);
    }
  }
  const auto null = static_cast<std::int32_t>(std::lround(options.null_cost * label_cost_scale));
  for (std::size_t i = 0; i < points.size(); ++i) costs[i * (parts + 1) + parts] = null;
}

}  // namespace archetype
