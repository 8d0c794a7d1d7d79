// Sums of the terms.
#include "core/fitting/energy.h"

#include <algorithm>
#include <cmath>

#include "core/fitting/point_graph.h"

namespace archetype {

double part_deformation(const TemplatePart& part, const Box& box, const FitOptions& options) {
  const double tail = options.deformation_tail;
  const Mat3 axes = box.orientation.conjugate().toRotationMatrix();
  const Vec3 precision = axes.cwiseAbs2() * part.position.stddev.cwiseAbs2().cwiseInverse();
  const Vec3 moved = axes * (box.centre - part.position.mean);
  const Vec3 scaled = (box.half_extent - part.scale.mean).cwiseQuotient(part.scale.stddev);
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    sum += tail * std::log1p(precision[axis] * moved[axis] * moved[axis] / tail);
    sum += tail * std::log1p(scaled[axis] * scaled[axis] / tail);
  }
  if (options.turn_stddev > 0) {
    const Vec3 turned = turn_vector(part.orientation.conjugate() * box.orientation) / options.turn_stddev;
    sum += tail * std::log1p(turned.squaredNorm() / tail);
  }
  return sum;
}

double existence_energy(const TemplatePart& part, bool present, const FitOptions& options) {
  // A prior of exactly 0 or 1 would forbid what one shape in a hundred does.
  const double existence = std::clamp(part.existence, 0.01, 0.99);
  return -options.existence_weight * std::log(present ? existence : 1 - existence);
}

FitEnergy fit_energy(const MatchedShape& shape, const PartTemplate& part_template, std::span<const Box> boxes,
                     std::span<const double> features, const LabellingGraph& graph,
                     const FitOptions& options) {
  const std::size_t parts = boxes.size();
  const double unit = shape.unit * shape.unit;
  const auto points = static_cast<double>(shape.points.size());
  FitEnergy energy;
  std::vector<bool> present(parts, false);
  std::int64_t twice_smooth = 0;
  double to_template = 0;
  double feature_sum = 0;
  for (std::size_t i = 0; i < shape.points.size(); ++i) {
    const std::int16_t label = shape.labels[i];
    for (const auto& n : graph.of(i)) twice_smooth += shape.labels[n.node] != label ? n.weight : 0;
    if (label == null_label) {
      feature_sum += options.null_cost;
      continue;
    }
    const auto k = static_cast<std::size_t>(label);
    present[k] = true;
    to_template += (boxes[k].to_world(shape.matches->on_template[i]) - shape.points[i]).squaredNorm();
    feature_sum += features[i * parts + k];
  }
  energy.shape_to_template = to_template / (points * unit);
  energy.features = feature_sum / points;
  energy.smoothness = static_cast<double>(twice_smooth) / (2 * label_cost_scale * points);
  double to_shape = 0;
  for (std::size_t k = 0; k < parts; ++k) {
    const TemplatePart& part = part_template.parts[k];
    energy.existence += existence_energy(part, present[k], options);
    if (!present[k]) {
      if (part.must_exist) energy.existence += missing_must_exist_energy;
      continue;
    }
    energy.deformation += options.alpha * part_deformation(part, boxes[k], options);
    for (auto t = shape.surface->begins[k]; t < shape.surface->begins[k + 1]; ++t) {
      const Vec3 on_template = boxes[k].to_world(on_solid(boxes[k].solid, shape.surface->local[t]));
      to_shape += (on_template - shape.points[shape.matches->on_shape[t]]).squaredNorm();
    }
  }
  energy.template_to_shape = to_shape / (static_cast<double>(shape.surface->local.size()) * unit);
  return energy;
}

}  // namespace archetype
