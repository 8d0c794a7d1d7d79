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
  PartTemplate absent = known;
  absent.parts[0].existence = 0;
  CHECK(cost(absent, 10) < cost(known, 10));
}
