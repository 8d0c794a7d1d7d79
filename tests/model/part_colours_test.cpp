#include "core/model/part_colours.h"

#include <doctest/doctest.h>

#include <set>

using namespace archetype;

TEST_CASE("part colours differ from each other and from the colour of no part, and then repeat") {
  std::set<Rgb> seen{part_colour(-1)};
  for (int part = 0; part < part_colour_count; ++part) {
    CHECK(seen.insert(part_colour(part)).second);
    CHECK(part_colour(part) == part_colour(part + part_colour_count));
  }
  CHECK(part_colour(-7) == part_colour(-1));
}
