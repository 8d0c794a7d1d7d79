#include "core/model/part_names.h"

#include <doctest/doctest.h>

#include <vector>

using archetype::common_part_name;

TEST_CASE("parts are called by the words that all their names begin with") {
  const auto name = [](const std::vector<std::string>& names) { return common_part_name(names); };
  CHECK(name({}) == "");
  CHECK(name({"seat"}) == "seat");
  CHECK(name({"leg front left", "leg back left", "leg"}) == "leg");
  CHECK(name({"leg front left", "leg front right"}) == "leg front");
  CHECK(name({"wing", "window"}) == "wing");
  CHECK(name({"leg", "legs"}) == "leg");
  CHECK(name({"", "leg"}) == "");
  CHECK(name({"a b", "a c", "d"}) == "a b");
}
