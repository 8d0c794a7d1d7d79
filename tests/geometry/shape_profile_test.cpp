#include "core/geometry/shape_profile.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

using namespace archetype;

TEST_CASE("a profile is the same for every yaw, and tells heights from widths") {
  std::vector<Vec3> points;
  std::vector<Vec3> turned;
  for (int i = 0; i < 200; ++i) {
    points.emplace_back(0.01 * (i % 7), 0.01 * i, 0.02 * (i % 3));
    turned.emplace_back(points.back().z(), points.back().y(), -points.back().x());
  }
  const ShapeProfile profile = shape_profile(points);
  const ShapeProfile other = shape_profile(turned);
  for (std::size_t k = 0; k < profile.size(); ++k) CHECK(profile[k] == doctest::Approx(other[k]));
  CHECK(std::is_sorted(profile.begin(), profile.begin() + profile_quantiles));
  CHECK(profile[profile_quantiles - 1] == doctest::Approx(1.93));
  CHECK(shape_profile(std::vector<Vec3>{{1, 2, 0}})[0] == 2.0F);
}
