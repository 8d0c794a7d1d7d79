#include "core/fitting/template_choice.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/fitting/correspondence.h"
#include "core/fitting/energy.h"
#include "core/fitting/fit_template.h"
#include "core/fitting/point_graph.h"
#include "tests/support/made_shapes.h"

using namespace archetype;

TEST_CASE("a template gains by what it expects exactly, of the parts that a shape has") {
  const test::MadeShape shape = test::make_shape("tables", {}, 0, 300);
  PartTemplate part_template = test::template_from(shape);
  ShapeFit fit = *fit_template(part_template, shape.samples, {});
  REQUIRE(fit.parts[0].present);
  for (std::size_t k = 0; k < fit.parts.size(); ++k) fit.parts[k].box = part_template.parts[k].mean_box();
  const auto choice = [&](double stddev) {
    part_template.parts[0].position.stddev = part_template.parts[0].scale.stddev = Vec3::Constant(stddev);
    return choice_energy(fit, part_template, shape.samples, {});
  };
  // Six Gaussians at their means, each half as wide.
  CHECK(choice(0.4) - choice(0.2) == doctest::Approx(6 * 2 * FitOptions{}.alpha * std::log(2.0)));
  fit.parts[0].present = false;
  CHECK(choice(0.4) == choice(0.2));
}

TEST_CASE("of the same fit, a template does not gain by expecting less of a part that is open") {
  GenerateOptions options;
  options.styles = {"table"};
  const test::MadeShape shape = test::make_shape("lamps", options, 0, 500);
  PartTemplate part_template = test::template_from(shape);
  for (TemplatePart& part : part_template.parts) part.has_features = true;  // or they would follow the boxes
  ShapeFit fit = *fit_template(part_template, shape.samples, {});
  for (FittedPart& part : fit.parts) part.box.solid = Solid::box;  // round ones count otherwise
  // The shade: of all boxes the one that is farthest from its samples, at its ends.
  const auto shade = std::ranges::max_element(part_template.parts, {},
                                              [](const TemplatePart& part) { return part.scale.mean.x(); });

  const std::vector<Box> boxes = fit.boxes();
  const std::vector<Vec3> points = fit.to_template(shape.samples.points);
  const KdTree tree(shape.samples.points);
  const LabellingGraph graph = make_point_graph(shape.samples, {});
  const std::vector<double> features(points.size() * boxes.size(), 0.0);
  const auto energy_with = [&](const PartTemplate& of) {
    const TemplateSurface surface = sample_template(of, FitOptions{}.template_points);
    Correspondences matches;
    match({&tree, points, fit.yaw_quarters, fit.translation}, fit.labels, boxes, surface, matches);
    const double unit = FitOptions{}.distance_unit * shape.samples.radius;
    return fit_energy({points, fit.labels, &surface, &matches, unit}, of, boxes, features, graph, {});
  };

  fit.energy = energy_with(part_template);
  const FitEnergy of_large = fit.energy;
  const double large = choice_energy(fit, part_template, shape.samples, {}) - of_large.deformation;
  shade->scale.mean *= 0.5;
  fit.energy = energy_with(part_template);
  const double small = choice_energy(fit, part_template, shape.samples, {}) - fit.energy.deformation;
  CHECK(fit.energy.template_to_shape < 0.8 * of_large.template_to_shape);
  CHECK(std::abs(large - small) < 0.05 * of_large.template_to_shape);

  // A part that the shape lacks says nothing of how near the others are.
  TemplatePart lacking = *shade;
  lacking.name = "lacking";
  part_template.parts.push_back(lacking);
  fit.parts.push_back({false, lacking.mean_box()});
  const double more = choice_energy(fit, part_template, shape.samples, {}) - fit.energy.deformation;
  CHECK(std::abs(more - small) < 0.05 * of_large.template_to_shape);
}

TEST_CASE("where templates are compared, a round part gains nothing by being just round enough") {
  GenerateOptions options;
  options.styles = {"table"};
  const test::MadeShape shape = test::make_shape("lamps", options, 0, 500);
  PartTemplate part_template = test::template_from(shape);
  part_template.parts.resize(1);
  ShapeFit fit = *fit_template(part_template, shape.samples, {});
  const auto choice = [&](double round_share) {
    FitOptions with;
    with.round_share = round_share;
    return choice_energy(fit, part_template, shape.samples, with);
  };
  // E_t->s of one part is the same by any area; null samples count in neither.
  fit.parts[0].box.solid = Solid::cylinder_y;
  const double counted_once = choice(1);
  const double twice = choice(0.5) - counted_once;
  CHECK(twice > 0.01);
  CHECK(choice(0.25) - counted_once == doctest::Approx(3 * twice));
  fit.parts[0].box.solid = Solid::box;
  CHECK(choice(0.25) == choice(1));
}
