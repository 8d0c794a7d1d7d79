// The constants that the terms of the energy leave out, and distances that tell nothing of the template.
#include "core/fitting/template_choice.h"

#include <cmath>
#include <vector>

#include "core/fitting/correspondence.h"
#include "core/fitting/energy.h"
#include "core/fitting/template_surface.h"
#include "core/geometry/kd_tree.h"

namespace archetype {

namespace {

// Spreads of these sizes cost nothing: those of new parts, so that energies stay of the size they had.
constexpr double usual_position_stddev = 0.2;
constexpr double usual_scale_stddev = 0.1;
constexpr double usual_feature_stddev = 0.2;

double box_spread(const TemplatePart& part) {
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    sum += std::log(part.position.stddev[axis] / usual_position_stddev);
    sum += std::log(part.scale.stddev[axis] / usual_scale_stddev);
  }
  return sum;
}

double mean_feature_spread(const TemplatePart& part) {
  double sum = 0;
  for (const double stddev : part.features.stddev) sum += std::log(stddev / usual_feature_stddev);
  return sum / static_cast<double>(part.features.stddev.size());
}

// E_s->t and E_t->s with the changes for comparisons.
double compared_distances(const ShapeFit& fit, const PartTemplate& part_template, const ShapeSamples& samples,
                          const FitOptions& options) {
  const std::vector<Box> boxes = fit.boxes();
  const std::vector<Vec3> points = fit.to_template(samples.points);
  const TemplateSurface surface = sample_template(part_template, options.template_points);
  const KdTree tree(samples.points);
  Correspondences matches;
  match({&tree, points, fit.yaw_quarters, fit.translation}, fit.labels, boxes, surface, matches);
  const auto handicap = [&](const Box& box) {
    return box.solid == Solid::box || options.round_share <= 0 ? 1 : 1 / options.round_share;
  };
  double to_template = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (fit.labels[i] == null_label) continue;
    const Box& box = boxes[static_cast<std::size_t>(fit.labels[i])];
    to_template += handicap(box) * (box.to_world(matches.on_template[i]) - points[i]).squaredNorm();
  }
  double sum = 0;
  double whole = 0;
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    if (!fit.parts[k].present || matches.on_shape[surface.begins[k]] == Correspondences::none) continue;
    double of_part = 0;
    for (auto t = surface.begins[k]; t < surface.begins[k + 1]; ++t) {
      const Vec3 on_template = boxes[k].to_world(on_solid(boxes[k].solid, surface.local[t]));
      of_part += (on_template - points[matches.on_shape[t]]).squaredNorm();
    }
    const double area = surface_area(boxes[k].half_extent);
    sum += handicap(boxes[k]) * area * of_part / (surface.begins[k + 1] - surface.begins[k]);
    whole += area;
  }
  const double unit = options.distance_unit * samples.radius;
  return (to_template / static_cast<double>(points.size()) + (whole > 0 ? sum / whole : 0)) / (unit * unit);
}

}  // namespace

double choice_energy(const ShapeFit& fit, const PartTemplate& part_template, const ShapeSamples& samples,
                     const FitOptions& options) {
  const PartTemplate known = with_expected_features(part_template);
  std::vector<double> shares(known.parts.size(), 0.0);
  for (const auto label : fit.labels) {
    if (label != null_label)
      shares[static_cast<std::size_t>(label)] += 1 / static_cast<double>(fit.labels.size());
  }
  double energy = compared_distances(fit, part_template, samples, options) + fit.energy.features +
                  fit.energy.smoothness + fit.energy.existence;
  for (std::size_t k = 0; k < shares.size(); ++k) {
    if (!fit.parts[k].present) continue;
    energy += options.alpha * part_deformation(known.parts[k], fit.parts[k].box, options);
    energy += 2 * options.alpha * box_spread(known.parts[k]);
    energy += 2 * options.gamma / options.feature_clip * shares[k] * mean_feature_spread(known.parts[k]);
  }
  return energy;
}

}  // namespace archetype
