#include "core/learning/split_template.h"

#include <doctest/doctest.h>

#include <algorithm>

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

}  // namespace

TEST_CASE("benches get a template of their own, and no chair takes it") {
  Case given;
  add_chairs(given.shapes, "plain", 6, points);
  add_chairs(given.shapes, "bench", 6, points);
  std::optional<TemplateSplit> split;
  REQUIRE(split_template(given.parent, given.members(), {}, {}, 2, {}, split));
  REQUIRE(split);
  CHECK(split->gain > 0);
  CHECK(split->judging_to_child == 6);
  CHECK(std::all_of(split->to_child.begin() + 1, split->to_child.begin() + 6,
                    [&](bool side) { return side == split->to_child[0]; }));
  const PartTemplate& benches = split->to_child[6] ? split->child.part_template : split->parent.part_template;
  const PartTemplate& chairs = split->to_child[6] ? split->parent.part_template : split->child.part_template;
  CHECK(benches.parts[0].scale.mean.x() > 1.2 * chairs.parts[0].scale.mean.x());
  CHECK(benches.parts.size() == chairs.parts.size());
}

TEST_CASE("proposals are divisions that leave enough on both sides, once with each kind of child") {
  Case given;
  add_chairs(given.shapes, "plain", 6, points);
  add_chairs(given.shapes, "bench", 6, points);
  const auto proposals = split_proposals(given.parent, given.members(), {});
  REQUIRE_FALSE(proposals.empty());
  for (const SplitProposal& each : proposals) {
    const auto taken = std::ranges::count(each.to_child, true);
    CHECK(taken >= 3);
    CHECK(taken <= 9);
  }
  // The same division may begin with a child that was stretched, and with one that was estimated.
  for (std::size_t a = 0; a < proposals.size(); ++a) {
    std::vector<bool> flipped = proposals[a].to_child;
    flipped.flip();
    const auto same = std::ranges::count_if(proposals, [&](const SplitProposal& other) {
      return other.to_child == proposals[a].to_child || other.to_child == flipped;
    });
    CHECK(same <= 2);
    for (std::size_t b = a + 1; b < proposals.size(); ++b) {
      if (proposals[b].to_child == proposals[a].to_child)
        CHECK_FALSE(proposals[b].child.part_template == proposals[a].child.part_template);
    }
  }
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
