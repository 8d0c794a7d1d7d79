#include "core/learning/redivide_templates.h"

#include <doctest/doctest.h>

#include "tests/support/two_templates.h"

using namespace archetype;
using archetype::test::cancelled;
using archetype::test::TwoTemplates;

namespace {

std::optional<TemplateSplit> redivided(const TwoTemplates& given) {
  const auto merge = given.merge();
  REQUIRE(merge);
  std::optional<TemplateSplit> split;
  REQUIRE(redivide_templates(given.first, given.second, given.members, given.sides, *merge, {}, {}, 2, {},
                             split));
  return split;
}

}  // namespace

TEST_CASE(
    "shapes that were left with another kind come to their own, and both templates keep what is theirs") {
  for (const std::size_t bench_side : {0, 1}) {
    TwoTemplates given;
    given.add("bench", 6, bench_side);
    given.add("plain", 6, 1 - bench_side);
    const Sides right = given.sides;
    for (const std::size_t i : {3, 4, 5}) given.sides[i] = 1 - bench_side;
    given.learn();
    LearnedTemplate& benches = bench_side == 0 ? given.first : given.second;
    LearnedTemplate& chairs = bench_side == 0 ? given.second : given.first;
    benches.part_template.name = "benches";
    benches.part_template.parts[0].colour = 3;
    chairs.part_template.name = "chairs";
    const auto split = redivided(given);
    REQUIRE(split);
    CHECK(split->sides == right);
    REQUIRE(split->templates.size() == 2);
    const LearnedTemplate& wide = split->templates[bench_side];
    const LearnedTemplate& narrow = split->templates[1 - bench_side];
    CHECK(wide.part_template.name == "benches");
    CHECK(wide.initial.name == "benches");
    CHECK(wide.part_template.parts[0].colour == 3);
    CHECK(narrow.part_template.name == "chairs");
    CHECK(narrow.part_template.parts[0].colour == -1);
    CHECK(wide.part_template.parts[0].scale.mean.x() > 1.2 * narrow.part_template.parts[0].scale.mean.x());
  }
}

TEST_CASE("a border that is right stays, and one that would leave a side without judges or other needs") {
  TwoTemplates given;
  given.add("bench", 6, 0);
  given.add("plain", 6, 1);
  given.learn();
  CHECK_FALSE(redivided(given));
  given.sides[3] = given.sides[4] = given.sides[5] = 1;
  given.learn();
  REQUIRE(redivided(given));
  TwoTemplates other = given;
  other.second.part_template.parts[0].must_exist = !other.second.part_template.parts[0].must_exist;
  CHECK_FALSE(redivided(other));
  // No more than the benches are asked.
  other = given;
  other.members.judging = 6;
  CHECK_FALSE(redivided(other));
}

TEST_CASE("a border that is sought says so when it is cancelled") {
  TwoTemplates given;
  given.add_halves(6);
  given.learn();
  std::optional<TemplateSplit> split;
  CHECK_FALSE(redivide_templates(given.first, given.second, given.members, given.sides, *given.merge(), {},
                                 {}, 2, cancelled(), split));
}
