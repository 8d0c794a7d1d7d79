// Means over samples and template samples, part by part.
#include "core/fitting/evidence.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/fitting/point_graph.h"

namespace archetype {

namespace {

double mean_squared_distance_to_shape(const MatchedShape& shape, const Box& box, std::size_t part) {
  const auto begin = shape.surface->begins[part];
  const auto end = shape.surface->begins[part + 1];
  double sum = 0;
  for (auto t = begin; t < end; ++t) {
    const Vec3 on_template = box.to_world(on_solid(box.solid, shape.surface->local[t]));
    sum += (on_template - shape.points[shape.matches->on_shape[t]]).squaredNorm();
  }
  return sum / ((end - begin) * shape.unit * shape.unit);
}

}  // namespace

std::vector<double> part_evidence(const MatchedShape& shape, const PartTemplate& part_template,
                                  std::span<const Box> boxes, const LabelCosts& costs,
                                  const FitOptions& options) {
  const std::size_t parts = boxes.size();
  const std::size_t count = parts + 1;
  std::vector<std::size_t> samples(parts, 0);
  for (const auto label : shape.labels) {
    if (label != null_label) ++samples[static_cast<std::size_t>(label)];
  }
  std::vector<double> gained(parts, 0);
  for (std::size_t i = 0; i < shape.points.size(); ++i) {
    if (shape.labels[i] == null_label) continue;
    const auto own = static_cast<std::size_t>(shape.labels[i]);
    const auto row = std::span(costs).subspan(i * count, count);
    std::int32_t other = row[parts];
    for (std::size_t k = 0; k < parts; ++k) {
      if (k != own && samples[k] > 0) other = std::min(other, row[k]);
    }
    gained[own] += (other - row[own]) / label_cost_scale;
  }
  std::vector<double> evidence(parts, std::numeric_limits<double>::infinity());
  for (std::size_t k = 0; k < parts; ++k) {
    const TemplatePart& part = part_template.parts[k];
    if (samples[k] == 0 || part.must_exist) continue;
    // As in the energy, no prior is quite certain.
    const double existence = std::clamp(part.existence, 0.01, 0.99);
    evidence[k] = gained[k] / static_cast<double>(samples[k]) -
                  mean_squared_distance_to_shape(shape, boxes[k], k) +
                  options.odds_weight * std::log(existence / (1 - existence));
  }
  return evidence;
}

}  // namespace archetype
