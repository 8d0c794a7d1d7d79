#include "core/learning/reestimate.h"

#include <doctest/doctest.h>

#include "core/fitting/deformation.h"

using namespace archetype;

namespace {

PartTemplate one_part() {
  PartTemplate result;
  result.name = "box";
  result.parts.resize(1);
  result.parts[0].existence = 0.5;
  return result;
}

std::vector<std::vector<PartObservation>> seen(std::size_t shapes, const Vec3& centre, bool present = true) {
  std::vector<std::vector<PartObservation>> observed(shapes);
  for (auto& shape : observed) {
    shape.resize(1);
    shape[0].present = present;
    shape[0].box.centre = centre;
    shape[0].box.half_extent = Vec3::Constant(0.4);
    shape[0].box.orientation = turn_rotation(Vec3(0, 0.3, 0));
    shape[0].samples = 10;
    shape[0].feature_sum.fill(5);       // a mean of 0.5
    shape[0].feature_square.fill(2.5);  // without spread
  }
  return observed;
}

// What is known before counts as 5 shapes for means, and as 20 for spreads.
LearnOptions of_known() {
  LearnOptions options;
  options.prior_shapes_of_means = 5;
  options.prior_shapes_of_spreads = 20;
  return options;
}

}  // namespace

TEST_CASE("what many shapes say outweighs what was known before") {
  const PartTemplate initial = one_part();
  const TemplatePart few = reestimate(initial, seen(5, {1, 0, 0}), of_known()).parts[0];
  const TemplatePart many = reestimate(initial, seen(995, {1, 0, 0}), of_known()).parts[0];
  CHECK(few.position.mean.x() == doctest::Approx(0.5));  // as many shapes as the prior counts for
  CHECK(many.position.mean.x() == doctest::Approx(0.995));
  CHECK(many.scale.mean.y() == doctest::Approx(0.2 * 0.005 + 0.4 * 0.995));
  // Shapes without any spread: the factor of all prior variances is 20 / (20 + 3 x 4) and at least 0.02.
  CHECK(few.position.stddev.y() == doctest::Approx(0.2 * std::sqrt(20.0 / 32.0 * 20.0 / 25.0)));
  CHECK(many.position.stddev.y() == doctest::Approx(0.2 * std::sqrt(0.02 * 20.0 / 1015.0)));
  CHECK(turn_vector(many.orientation).y() == doctest::Approx(0.3 * 0.995));
  CHECK(many.features.mean[2] == doctest::Approx(0.5).epsilon(0.02));
  CHECK(many.features.stddev[2] == LearnOptions{}.smallest_feature_spread);
  CHECK(many.has_features);
}

TEST_CASE("the share of shapes that have a part becomes its existence") {
  std::vector<std::vector<PartObservation>> observed = seen(30, {0, 0, 0});
  for (auto& shape : seen(70, {0, 0, 0}, false)) observed.push_back(shape);
  const TemplatePart part = reestimate(one_part(), observed, of_known()).parts[0];
  CHECK(part.existence == doctest::Approx((30 + 2.5) / 105));
  const TemplatePart none = reestimate(one_part(), seen(10, {9, 9, 9}, false), {}).parts[0];
  CHECK(none.position.mean == one_part().parts[0].position.mean);
  CHECK(none.existence > 0);
}

TEST_CASE("turns go to vectors and back") {
  for (const Vec3& turn : {Vec3(0, 0, 0), Vec3(0.3, -0.2, 0.1), Vec3(0, 3, 0), Vec3(1e-11, 0, 0)}) {
    CHECK((turn_vector(turn_rotation(turn)) - turn).norm() < 1e-9);
  }
  const Eigen::Quaterniond q = turn_rotation(Vec3(0.3, 0, 0));
  CHECK((turn_vector(Eigen::Quaterniond(-q.coeffs())) - Vec3(0.3, 0, 0)).norm() < 1e-9);  // the same rotation
}
