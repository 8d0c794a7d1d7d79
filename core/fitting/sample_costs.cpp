#include "core/fitting/sample_costs.h"

#include "core/fitting/label_costs.h"
#include "core/fitting/point_graph.h"
#include "core/fitting/template_surface.h"

namespace archetype {

std::vector<double> sample_costs(const PartTemplate& part_template, const ShapeSamples& samples,
                                 const ShapeFit& fit, const FitOptions& options) {
  const bool odd = (fit.yaw_quarters & 1) != 0;
  const std::vector<double> features = feature_costs(with_expected_features(part_template),
                                                     odd ? samples.features_z : samples.features_x, options);
  const std::vector<Vec3> points = fit.to_template(samples.points);
  const std::vector<Box> boxes = fit.boxes();
  LabelCosts costs;
  label_costs(points, boxes, features, options.distance_unit * samples.radius, options, costs);
  std::vector<double> result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t label =
        fit.labels[i] == null_label ? boxes.size() : static_cast<std::size_t>(fit.labels[i]);
    result.push_back(costs[i * (boxes.size() + 1) + label] / label_cost_scale);
  }
  return result;
}

}  // namespace archetype
