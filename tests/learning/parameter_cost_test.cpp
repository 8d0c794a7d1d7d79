#include "core/learning/parameter_cost.h"

#include <doctest/doctest.h>

#include "tests/support/small_collection.h"

using namespace archetype;
using namespace archetype::test;

TEST_CASE(
    "parameters cost more the narrower they are, the farther they moved, and the more shapes tell them") {
  const PartTemplate known = chair_template();
  const auto cost = [&](const PartTemplate& found, std::size_t members) {
    return parameter_cost(found, known, members, {}, {});
  };
  CHECK(cost(known, 0) == 0);
  CHECK(cost(known, 10) > cost(known, 5));
  PartTemplate narrow = known;
  narrow.parts[0].position.stddev /= 4;
  CHECK(cost(narrow, 10) > cost(known, 10));
  PartTemplate moved = known;
  moved.parts[0].scale.mean.x() += known.parts[0].scale.stddev.x();
  CHECK(cost(moved, 10) > cost(known, 10));
  // Of one part, worked out beside the program: 10 shapes, position known up to 0.2 and found within 0.1,
  // moved by 0.1 along one axis; size known up to 0.1 and found within 0.05; spreads known by 8 shapes.
  PartTemplate one;
  one.parts.resize(1);
  one.parts[0].existence = 1;
  one.parts[0].position = {Vec3::Zero(), Vec3::Constant(0.2)};
  one.parts[0].scale = {Vec3::Constant(0.5), Vec3::Constant(0.1)};
  PartTemplate found = one;
  found.parts[0].position = {Vec3(0.1, 0, 0), Vec3::Constant(0.1)};
  found.parts[0].scale.stddev = Vec3::Constant(0.05);
  CHECK(parameter_cost(found, one, 10, {}, {}) == doctest::Approx(FitOptions{}.alpha * 24.326604));
  PartTemplate absent = known;
  absent.parts[0].existence = 0;
  CHECK(cost(absent, 10) < cost(known, 10));
}
