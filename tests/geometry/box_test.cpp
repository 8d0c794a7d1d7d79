#include "core/geometry/box.h"

#include <doctest/doctest.h>

#include "core/base/random.h"
#include "core/fitting/label_costs.h"

using namespace archetype;

TEST_CASE("the closest point on a box is none farther than any sampled one") {
  RandomStream random(9);
  for (int round = 0; round < 200; ++round) {
    Box box;
    box.centre = Vec3(random.normal(), random.normal(), random.normal());
    box.half_extent = Vec3(random.uniform(0.05, 1), random.uniform(0.05, 1), random.uniform(0.05, 1));
    if (round % 2 == 0) {
      box.orientation =
          Eigen::Quaterniond(random.normal(), random.normal(), random.normal(), random.normal()).normalized();
    }
    const Vec3 p =
        box.to_world(2 * Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)));
    const Vec3 local = closest_on_surface(box, p);
    CHECK(local.cwiseAbs().maxCoeff() == doctest::Approx(1));
    const double distance = (box.to_world(local) - p).norm();
    CHECK(BoxDistance(box).squared(p) == doctest::Approx(distance * distance).epsilon(1e-9));
    CHECK((box.to_world(box.to_local(p)) - p).norm() < 1e-9);
    for (int s = 0; s < 300; ++s) {
      Vec3 other(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
      other[static_cast<Eigen::Index>(random.below(3))] = random.below(2) == 0 ? 1 : -1;
      REQUIRE((box.to_world(other) - p).norm() >= distance - 1e-9);
    }
  }
}
