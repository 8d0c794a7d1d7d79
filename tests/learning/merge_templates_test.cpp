#include "core/learning/merge_templates.h"

#include <doctest/doctest.h>

#include "tests/support/two_templates.h"

using namespace archetype;
using archetype::test::cancelled;
using archetype::test::TwoTemplates;

TEST_CASE("two templates of one kind of shapes become one, those of two kinds do not") {
  TwoTemplates alike;
  alike.add_halves(12);
  alike.learn();
  const auto one = alike.merge();
  REQUIRE(one);
  CHECK(one->gain > 0);
  CHECK(one->seen.size() == 12);
  CHECK(one->part_template.parts.size() == alike.first.part_template.parts.size());

  TwoTemplates different;
  different.add("plain", 6, 0);
  different.add("bench", 6, 1);
  different.learn();
  const auto neither = different.merge();
  REQUIRE(neither);
  CHECK(neither->gain < 0);
}

TEST_CASE("templates of other parts, and those that no judging shape takes, are not merged") {
  TwoTemplates given;
  given.add_halves(6);
  given.learn();
  TwoTemplates other = given;
  other.second.part_template.parts.front().name = "lid";
  CHECK_FALSE(other.merge());
  other = given;
  other.members.judging = 3;
  CHECK_FALSE(other.merge());
}

TEST_CASE("a merge that is cancelled says so") {
  TwoTemplates given;
  given.add_halves(6);
  given.learn();
  std::optional<TemplateMerge> merge;
  CHECK_FALSE(
      merge_templates(given.first, given.second, given.members, given.sides, {}, {}, 2, cancelled(), merge));
}
