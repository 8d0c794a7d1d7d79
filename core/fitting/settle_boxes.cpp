#include "core/fitting/settle_boxes.h"

#include "core/fitting/correspondence.h"
#include "core/fitting/deformation.h"
#include "core/fitting/template_surface.h"
#include "core/geometry/kd_tree.h"

namespace archetype {

std::vector<Box> settle_boxes(const PartTemplate& part_template, const ShapeSamples& samples,
                              const ShapeFit& fit, const FitOptions& options, int steps) {
  std::vector<Box> boxes = fit.boxes();
  if (boxes.empty() || samples.size() == 0) return boxes;
  const std::vector<Vec3> points = fit.to_template(samples.points);
  const KdTree tree(samples.points);
  const TemplateSurface surface = sample_template(part_template, options.template_points);
  const PlacedSamples placed{&tree, points, fit.yaw_quarters, fit.translation};
  Correspondences matches;
  const MatchedShape shape{points, fit.labels, &surface, &matches, options.distance_unit * samples.radius};
  for (int step = 0; step < steps; ++step) {
    match(placed, fit.labels, boxes, surface, matches);
    deformation_step(shape, part_template, options, boxes);
  }
  return boxes;
}

}  // namespace archetype
