#include "core/evaluation/coalign.h"

#include <doctest/doctest.h>

#include "core/base/error.h"
#include "core/fitting/template_surface.h"

using namespace archetype;

namespace {

PartTemplate one_box() {
  PartTemplate part_template;
  part_template.parts.resize(1);
  part_template.parts[0].position.mean = {1, 0, 0};
  part_template.parts[0].scale.mean = {1, 2, 3};
  part_template.parts[0].orientation = Eigen::Quaterniond(Eigen::AngleAxisd(0.4, Vec3::UnitY()));
  return part_template;
}

void check_near(const Vec3& a, const Vec3& b) {
  CHECK((a - b).norm() < 1e-12);
}

}  // namespace

TEST_CASE("what lies on the fitted box comes to lie on the mean box, whatever yaw, place and size it has") {
  const PartTemplate part_template = one_box();
  ShapeFit fit;
  fit.yaw_quarters = 1;
  fit.translation = {0.3, -0.2, 0.1};
  fit.parts.push_back({true, {{2, 1, -1}, {0.5, 0.1, 4}, part_template.parts[0].orientation}});
  const Box& fitted = fit.parts[0].box;
  ShapeSamples samples;
  const std::vector<Vec3> on_box{{1, 0.3, -0.2}, {0.1, -1, 0.9}, {1, 1, 1}};
  for (const Vec3& local : on_box) samples.points.push_back(fit.to_shape(fitted.to_world(local)));
  // A fourth one 0.05 in front of the first, which no deformation changes.
  const Vec3 offset = part_template.parts[0].orientation * Vec3(0.05, 0, 0);
  samples.points.push_back(fit.to_shape(fitted.to_world(on_box[0]) + offset));
  fit.labels = {0, 0, 0, 0};

  const Coaligned coaligned = coalign(part_template, samples, fit, std::vector{fitted});
  const std::vector<Vec3>& canonical = coaligned.deformed;
  REQUIRE(canonical.size() == 4);
  const Box mean = part_template.parts[0].mean_box();
  for (std::size_t i = 0; i < on_box.size(); ++i) check_near(canonical[i], mean.to_world(on_box[i]));
  check_near(canonical[3], mean.to_world(on_box[0]) + offset);
  check_near(coaligned.rigid[2], fitted.to_world(on_box[2]));
  // All that is left is the offset of the fourth.
  CHECK(coaligned.sharpness.samples == 4);
  CHECK(coaligned.sharpness.mean_deformed() == doctest::Approx(0.05 * 0.05 / 4));
  CHECK(coaligned.sharpness.mean_rigid() > 1);
  // Between the ends it is what is measured there.
  const std::vector<Vec3> place{mean.to_world(on_box[0]), mean.to_world(on_box[1]), mean.to_world(on_box[2]),
                                mean.to_world(on_box[0])};
  for (const double blend : {0.0, 0.3, 0.75, 1.0}) {
    double measured = 0;
    for (std::size_t i = 0; i < place.size(); ++i)
      measured += ((1 - blend) * coaligned.rigid[i] + blend * canonical[i] - place[i]).squaredNorm() / 4;
    CHECK(coaligned.sharpness.mean_at(blend) == doctest::Approx(measured));
  }
}

TEST_CASE("free boxes follow the surface where the template's spread holds the fitted ones back") {
  PartTemplate part_template = one_box();
  TemplatePart& part = part_template.parts[0];
  part.orientation = Eigen::Quaterniond::Identity();
  part.position.stddev = part.scale.stddev = Vec3::Constant(0.001);
  // A box of other place and size, with samples all over it; the fit has not moved from the mean box.
  const Box actual{{1.3, -0.2, 0.1}, {1.4, 1.7, 3.3}};
  ShapeSamples samples;
  samples.radius = 8;
  for (const Vec3& local : sample_template(part_template, 2000).local)
    samples.points.push_back(actual.to_world(local));
  ShapeFit fit;
  fit.parts.push_back({true, part.mean_box()});
  fit.labels.assign(samples.size(), 0);
  const std::vector<Box> boxes = free_boxes(part_template, samples, fit);
  CHECK((boxes[0].centre - actual.centre).norm() < 0.06);
  CHECK((boxes[0].half_extent - actual.half_extent).norm() < 0.06);
  const double held = coalign(part_template, samples, fit, std::vector{fit.parts[0].box}).sharpness.deformed;
  const double freed = coalign(part_template, samples, fit, boxes).sharpness.deformed;
  CHECK(freed < 0.02 * held);
  fit.labels.pop_back();
  CHECK_THROWS_AS(free_boxes(part_template, samples, fit), PreconditionError);
}

TEST_CASE("a part that was not found keeps its mean box") {
  const PartTemplate part_template = one_box();
  ShapeSamples samples;
  samples.points = {{1, 2, 3}, {1, 2, 4}};
  samples.radius = 1;
  ShapeFit fit;
  fit.parts.push_back({false, part_template.parts[0].mean_box()});
  fit.labels = {null_label, null_label};
  const std::vector<Box> boxes = free_boxes(part_template, samples, fit);
  CHECK(boxes[0].centre == part_template.parts[0].mean_box().centre);
  const Coaligned coaligned = coalign(part_template, samples, fit, boxes);
  CHECK(coaligned.sharpness.samples == 0);
  CHECK(coaligned.sharpness.mean_deformed() == 0);
  CHECK(coaligned.sharpness.mean_at(0.5) == 0);
}

TEST_CASE("samples of no part are only turned and moved") {
  ShapeFit fit;
  fit.yaw_quarters = 2;
  fit.translation = {0, 1, 0};
  fit.parts.resize(1);
  fit.labels = {null_label};
  ShapeSamples samples;
  samples.points = {{1, 2, 3}};
  check_near(coalign(one_box(), samples, fit).at(0), {-1, 1, -3});
  fit.labels.clear();
  CHECK_THROWS_AS(coalign(one_box(), samples, fit), PreconditionError);
}
