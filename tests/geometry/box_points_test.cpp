#include "core/geometry/box_points.h"

#include <doctest/doctest.h>

#include "core/base/random.h"

using namespace archetype;

namespace {

Box some_box() {
  return {{0.2, -0.1, 0.4}, {0.5, 0.3, 0.2}, Eigen::Quaterniond(0.9, 0.2, -0.3, 0.1).normalized()};
}

std::vector<Vec3> points_in(const Box& box, const Vec3& within, RandomStream& random) {
  std::vector<Vec3> points;
  for (int i = 0; i < 200; ++i) {
    Vec3 local;
    for (int k = 0; k < 3; ++k) local[k] = within[k] * random.uniform(-1, 1);
    points.push_back(box.to_world(local));
  }
  return points;
}

}  // namespace

TEST_CASE("a box grows to hold all points, keeps its axes, and never shrinks") {
  RandomStream random(1);
  const Box box = some_box();
  CHECK((grown_to(box, points_in(box, {0.9, 0.9, 0.9}, random)).half_extent - box.half_extent).norm() <
        1e-12);
  const std::vector<Vec3> wide = points_in(box, {2, 0.5, 3}, random);
  const Box grown = grown_to(box, wide);
  CHECK(std::abs(grown.orientation.dot(box.orientation)) > 1 - 1e-12);
  CHECK(grown.half_extent.y() == doctest::Approx(box.half_extent.y()));
  double most = 0;
  for (const Vec3& point : wide) most = std::max(most, grown.to_local(point).cwiseAbs().maxCoeff());
  CHECK(most == doctest::Approx(1));
}

TEST_CASE("a box shrinks to the points inside of it and does not mind those outside") {
  RandomStream random(2);
  const Box box = some_box();
  std::vector<Vec3> points = points_in(box, {0.5, 0.8, 0.2}, random);
  const Box tight = box_around(points, box.orientation);
  points.push_back(box.to_world({3, 0, 0}));
  const Box shrunk = shrunk_to(box, points);
  CHECK((shrunk.centre - tight.centre).norm() < 1e-12);
  CHECK((shrunk.half_extent - tight.half_extent).norm() < 1e-12);
  CHECK(shrunk.half_extent.z() < 0.21 * box.half_extent.z());
  CHECK(shrunk_to(box, {}).half_extent == box.half_extent);
}
