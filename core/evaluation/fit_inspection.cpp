// The sums of core/fitting/energy.cpp, kept apart.
#include "core/evaluation/fit_inspection.h"

#include "core/base/error.h"
#include "core/fitting/correspondence.h"
#include "core/fitting/energy.h"
#include "core/fitting/expected_template.h"
#include "core/fitting/label_costs.h"
#include "core/fitting/point_graph.h"

namespace archetype {

namespace {

struct Inspected {
  const PartTemplate part_template;  // expected
  const ShapeSamples& samples;
  const ShapeFit& fit;
  const FitOptions& options;
  double squared_unit = 1;
  std::vector<Vec3> points = {};  // template's frame
  std::vector<Box> boxes = {};
};

void add_samples(const Inspected& of, const Correspondences& matches, FitInspection& result) {
  const std::size_t parts = of.boxes.size();
  const bool odd = (of.fit.yaw_quarters & 1) != 0;
  const std::vector<double> features =
      feature_costs(of.part_template, odd ? of.samples.features_z : of.samples.features_x, of.options);
  const LabellingGraph graph = make_point_graph(of.samples, of.options);
  const auto count = static_cast<double>(of.points.size());
  for (std::size_t i = 0; i < of.points.size(); ++i) {
    const std::int16_t label = of.fit.labels[i];
    const std::size_t part = label == null_label ? parts : static_cast<std::size_t>(label);
    const bool null = part == parts;
    result.on_template.push_back(null ? of.points[i] : of.boxes[part].to_world(matches.on_template[i]));
    result.shape_to_template.push_back((result.on_template[i] - of.points[i]).squaredNorm() /
                                       of.squared_unit);
    result.features.push_back(null ? of.options.null_cost : features[i * parts + part]);
    std::int64_t twice_smooth = 0;
    for (const auto& n : graph.of(i)) twice_smooth += of.fit.labels[n.node] != label ? n.weight : 0;
    result.smoothness.push_back(static_cast<double>(twice_smooth) / (2 * label_cost_scale));
    FitEnergy& energy = result.parts[part];
    energy.shape_to_template += result.shape_to_template[i] / count;
    energy.features += result.features[i] / count;
    energy.smoothness += result.smoothness[i] / count;
  }
}

void add_template_points(const Inspected& of, const TemplateSurface& surface, const Correspondences& matches,
                         FitInspection& result) {
  const auto count = static_cast<double>(surface.local.size());
  for (std::size_t k = 0; k < of.boxes.size(); ++k) {
    if (!of.fit.parts[k].present) continue;
    for (auto t = surface.begins[k]; t < surface.begins[k + 1]; ++t) {
      const Box& box = of.boxes[k];
      FitInspection::TemplatePoint point;
      point.position = box.to_world(on_solid(box.solid, surface.local[t]));
      point.part = static_cast<std::int16_t>(k);
      point.sample = matches.on_shape[t];
      if (point.sample == Correspondences::none) continue;
      point.distance = (point.position - of.points[point.sample]).squaredNorm() / of.squared_unit;
      result.parts[k].template_to_shape += point.distance / count;
      result.template_points.push_back(point);
    }
  }
}

void add_priors(const Inspected& of, FitInspection& result) {
  for (std::size_t k = 0; k < of.boxes.size(); ++k) {
    const TemplatePart& part = of.part_template.parts[k];
    FitEnergy& energy = result.parts[k];
    const bool present = of.fit.parts[k].present;
    energy.existence = existence_energy(part, present, of.options);
    if (!present && part.must_exist) energy.existence += missing_must_exist_energy;
    if (present) energy.deformation = of.options.alpha * part_deformation(part, of.boxes[k], of.options);
  }
}

}  // namespace

FitInspection inspect_fit(const PartTemplate& part_template, const ShapeSamples& samples, const ShapeFit& fit,
                          const FitOptions& options) {
  if (fit.labels.size() != samples.size() || fit.parts.size() != part_template.parts.size() ||
      samples.size() == 0 || part_template.parts.empty())
    throw PreconditionError("only a fit of these samples by this template can be inspected");
  const double unit = options.distance_unit * samples.radius;
  Inspected of{expected_template(part_template), samples, fit, options, unit * unit};
  of.points = fit.to_template(samples.points);
  of.boxes = fit.boxes();
  const KdTree tree(samples.points);
  const TemplateSurface surface = sample_template(of.part_template, options.template_points);
  Correspondences matches;
  match({&tree, of.points, fit.yaw_quarters, fit.translation}, fit.labels, of.boxes, surface, matches);
  FitInspection result;
  result.parts.resize(fit.parts.size() + 1);
  add_samples(of, matches, result);
  add_template_points(of, surface, matches, result);
  add_priors(of, result);
  return result;
}

}  // namespace archetype
