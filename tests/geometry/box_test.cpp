#include "core/geometry/box.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/base/random.h"
#include "core/fitting/label_costs.h"

using namespace archetype;

namespace {

constexpr std::array solids{Solid::box, Solid::cylinder_x, Solid::cylinder_y, Solid::cylinder_z,
                            Solid::ellipsoid};

Box random_box(RandomStream& random, int round) {
  Box box;
  box.centre = Vec3(random.normal(), random.normal(), random.normal());
  box.half_extent = Vec3(random.uniform(0.05, 1), random.uniform(0.05, 1), random.uniform(0.05, 1));
  if (round % 2 == 0) {
    box.orientation =
        Eigen::Quaterniond(random.normal(), random.normal(), random.normal(), random.normal()).normalized();
  }
  return box;
}

Vec3 random_on_box(RandomStream& random) {
  Vec3 p(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
  p[static_cast<Eigen::Index>(random.below(3))] = random.below(2) == 0 ? 1 : -1;
  return p;
}

// 1 on the surface of the solid, less inside.
double depth(Solid solid, const Vec3& local) {
  const double ball = std::cbrt(6 / std::numbers::pi);
  if (solid == Solid::box) return local.cwiseAbs().maxCoeff();
  if (solid == Solid::ellipsoid) return local.norm() / ball;
  const int axis = static_cast<int>(solid) - 1;
  const double around = std::hypot(local[(axis + 1) % 3], local[(axis + 2) % 3]);
  return std::max(std::abs(local[axis]), around / std::sqrt(4 / std::numbers::pi));
}

}  // namespace

TEST_CASE("the closest point on a solid is none farther than any other on it") {
  RandomStream random(9);
  for (int round = 0; round < 400; ++round) {
    Box box = random_box(random, round);
    box.solid = solids[static_cast<std::size_t>(round) % solids.size()];
    Vec3 at = 2 * Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    if (round % 7 == 0) at[static_cast<Eigen::Index>(random.below(3))] = 0;
    if (round % 49 == 0) at = Vec3::Zero();
    const Vec3 p = box.to_world(at);
    const Vec3 local = closest_on_surface(box, p);
    CHECK(depth(box.solid, local) == doctest::Approx(1));
    const double distance = (box.to_world(local) - p).norm();
    CHECK(BoxDistance(box).squared(p) == doctest::Approx(distance * distance).epsilon(1e-9));
    CHECK((box.to_world(box.to_local(p)) - p).norm() < 1e-9);
    for (int s = 0; s < 300; ++s) {
      const Vec3 other = on_solid(box.solid, random_on_box(random));
      REQUIRE(depth(box.solid, other) == doctest::Approx(1));
      REQUIRE((box.to_world(other) - p).norm() >= distance - 1e-5);
    }
  }
}
