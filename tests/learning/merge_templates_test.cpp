#include "core/learning/merge_templates.h"

#include <doctest/doctest.h>

#include "tests/support/made_shapes.h"
#include "tests/support/small_collection.h"

using namespace archetype;
using namespace archetype::test;

namespace {

constexpr int points = 300;  // of each shape

// Two templates that were learned from the first half of the shapes and from the second.
struct Halves {
  std::vector<ShapeSamples> shapes;
  LearnedTemplate first{chair_template(), chair_template()};
  LearnedTemplate second = first;
  TemplateMembers members;
  Sides sides;

  void learn() {
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      members.shapes.push_back({&shapes[i], {}});
      sides.push_back(2 * i < shapes.size() ? 0 : 1);
    }
    members.judging = shapes.size();
    for (std::size_t side = 0; side < 2; ++side) {
      LearnedTemplate& each = side == 0 ? first : second;
      std::vector<LearningShape> half;
      for (std::size_t i = 0; i < shapes.size(); ++i)
        if (sides[i] == side) half.push_back(members.shapes[i]);
      std::vector<Sighting> seen;
      for (int step = 0; step < 2; ++step) {
        seen = sightings(each.part_template, half, {}, 2, {}).value();
        std::vector<std::vector<PartObservation>> observed;
        for (const Sighting& one : seen) observed.push_back(one.parts);
        each.part_template = reestimate(each.initial, observed, {});
      }
      std::ranges::move(sightings(each.part_template, half, {}, 2, {}).value(),
                        std::back_inserter(members.seen));
    }
  }
  std::optional<TemplateMerge> merge() const {
    std::optional<TemplateMerge> result;
    REQUIRE(merge_templates(first, second, members, sides, {}, {}, 2, {}, result));
    return result;
  }
};

}  // namespace

TEST_CASE("two templates of one kind of shapes become one, those of two kinds do not") {
  Halves alike;
  add_chairs(alike.shapes, "plain", 12, points);
  alike.learn();
  const auto one = alike.merge();
  REQUIRE(one);
  CHECK(one->gain > 0);
  CHECK(one->seen.size() == 12);
  CHECK(one->part_template.parts.size() == alike.first.part_template.parts.size());

  Halves different;
  add_chairs(different.shapes, "plain", 6, points);
  add_chairs(different.shapes, "bench", 6, points);
  different.learn();
  const auto neither = different.merge();
  REQUIRE(neither);
  CHECK(neither->gain < 0);
}

TEST_CASE("templates of other parts, and those that no judging shape takes, are not merged") {
  Halves given;
  add_chairs(given.shapes, "plain", 6, points);
  given.learn();
  Halves other = given;
  other.second.part_template.parts.front().name = "lid";
  CHECK_FALSE(other.merge());
  other = given;
  other.members.judging = 3;
  CHECK_FALSE(other.merge());
}

TEST_CASE("a merge that is cancelled says so") {
  Halves given;
  add_chairs(given.shapes, "plain", 6, points);
  given.learn();
  std::stop_source source;
  source.request_stop();
  JobControl control;
  control.stop = source.get_token();
  std::optional<TemplateMerge> merge;
  CHECK_FALSE(
      merge_templates(given.first, given.second, given.members, given.sides, {}, {}, 2, control, merge));
}
