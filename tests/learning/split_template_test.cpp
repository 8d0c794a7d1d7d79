#include "core/learning/split_template.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>

#include "tests/support/made_shapes.h"
#include "tests/support/small_collection.h"

using namespace archetype;
using namespace archetype::test;

namespace {

constexpr int points = 300;  // of each shape

struct Case {
  std::vector<ShapeSamples> shapes;
  LearnedTemplate parent{chair_template(), chair_template()};

  TemplateMembers members() const {
    TemplateMembers result;
    for (const ShapeSamples& each : shapes) result.shapes.push_back({&each, {}});
    result.seen = sightings(parent.part_template, result.shapes, {}, 2, {}).value();
    result.judging = shapes.size();
    return result;
  }
};

// Whether two divisions are the same but for their numbers.
bool one_to_one(const Sides& a, const Sides& b) {
  std::map<std::size_t, std::set<std::size_t>> there;
  std::map<std::size_t, std::set<std::size_t>> back;
  for (std::size_t i = 0; i < a.size(); ++i) {
    there[a[i]].insert(b[i]);
    back[b[i]].insert(a[i]);
  }
  const auto single = [](const auto& entry) { return entry.second.size() == 1; };
  return std::ranges::all_of(there, single) && std::ranges::all_of(back, single);
}

}  // namespace

TEST_CASE("benches get a template of their own, and no chair takes it") {
  Case given;
  add_chairs(given.shapes, "plain", 6, points);
  add_chairs(given.shapes, "bench", 6, points);
  std::optional<TemplateSplit> split;
  REQUIRE(split_template(given.parent, given.members(), {}, {}, 2, {}, split));
  REQUIRE(split);
  CHECK(split->gain > 0);
  REQUIRE(split->templates.size() == 2);
  CHECK(std::ranges::count(split->sides, split->sides[0]) == 6);
  CHECK(std::all_of(split->sides.begin() + 1, split->sides.begin() + 6,
                    [&](std::size_t side) { return side == split->sides[0]; }));
  const PartTemplate& benches = split->templates[split->sides[6]].part_template;
  const PartTemplate& chairs = split->templates[split->sides[0]].part_template;
  CHECK(benches.parts[0].scale.mean.x() > 1.2 * chairs.parts[0].scale.mean.x());
  CHECK(benches.parts.size() == chairs.parts.size());
}

TEST_CASE("proposals are divisions that leave enough on both sides, once with each kind of child") {
  Case given;
  add_chairs(given.shapes, "plain", 6, points);
  add_chairs(given.shapes, "bench", 6, points);
  add_chairs(given.shapes, "high", 6, points);
  const auto proposals = split_proposals(given.parent, given.members(), {});
  REQUIRE_FALSE(proposals.empty());
  bool in_three = false;
  for (const SplitProposal& each : proposals) {
    REQUIRE(each.sides.size() == 18);
    in_three |= each.templates.size() == 3;
    for (std::size_t side = 0; side < each.templates.size(); ++side)
      CHECK(std::ranges::count(each.sides, side) >= 3);
  }
  CHECK(in_three);
  // The same division may begin with a child that was stretched, and with one that was estimated.
  for (std::size_t a = 0; a < proposals.size(); ++a) {
    const auto same = std::ranges::count_if(
        proposals, [&](const SplitProposal& other) { return one_to_one(proposals[a].sides, other.sides); });
    CHECK(same <= 2);
    for (std::size_t b = a + 1; b < proposals.size(); ++b) {
      if (proposals[b].sides == proposals[a].sides)
        CHECK_FALSE(proposals[b].templates[1].part_template == proposals[a].templates[1].part_template);
    }
  }
}

TEST_CASE("what leaves few shapes on a side has to gain twice as much, and none may be left fewer") {
  Case given;
  add_chairs(given.shapes, "plain", 6, points);
  add_chairs(given.shapes, "bench", 4, points);
  const TemplateMembers members = given.members();
  LearnOptions options;
  const auto split = [&](double least_gain) {
    std::optional<TemplateSplit> result;
    REQUIRE(split_template(given.parent, members, {}, options, 2, {}, result, least_gain));
    return result;
  };
  const auto is_by_kind = [](const std::optional<TemplateSplit>& each) {
    return each && one_to_one(each->sides, {0, 0, 0, 0, 0, 0, 1, 1, 1, 1});
  };
  const auto best = split(0);
  REQUIRE(is_by_kind(best));
  CHECK_FALSE(is_by_kind(split(0.51 * best->gain)));
  options.smallest_sure_cluster = 4;
  CHECK(is_by_kind(split(0.99 * best->gain)));
  options.smallest_cluster = 5;
  CHECK_FALSE(is_by_kind(split(0)));
}

TEST_CASE("a division that is cancelled says so") {
  Case given;
  add_chairs(given.shapes, "plain", 6, points);
  add_chairs(given.shapes, "bench", 6, points);
  const TemplateMembers members = given.members();
  std::stop_source source;
  source.request_stop();
  std::optional<TemplateSplit> split;
  JobControl control;
  control.stop = source.get_token();
  CHECK_FALSE(split_template(given.parent, members, {}, {}, 2, control, split));
}
