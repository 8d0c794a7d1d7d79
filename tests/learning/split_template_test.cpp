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

TEST_CASE("chairs part by arms that were taken to be certain") {
  Case given;
  add_chairs(given.shapes, "plain", 6, points);
  add_chairs(given.shapes, "arms", 6, points);
  GenerateOptions with_arms;
  with_arms.styles = {"arms"};
  PartTemplate start = template_from(make_shape("chairs", with_arms, 0));
  for (TemplatePart& part : start.parts) part.existence = 0.99;
  given.parent = {start, start};
  const auto& names = family_names("chairs").labels;
  const auto arm = static_cast<int>(std::ranges::find(names, "arm") - names.begin());
  const TemplateMembers members = given.members();
  int arms_on_plain_chairs = 0;
  for (std::size_t k = 0; k < start.parts.size(); ++k)
    for (std::size_t i = 0; start.parts[k].label == arm && i < 6; ++i)
      arms_on_plain_chairs += members.seen[i].parts[k].present ? 1 : 0;
  REQUIRE(arms_on_plain_chairs >= 12);
  std::optional<TemplateSplit> split;
  REQUIRE(split_template(given.parent, members, {}, {}, 2, {}, split));
  REQUIRE(split);
  REQUIRE(one_to_one(split->sides, {0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1}));
  // Arms and their posts, seen by the template that each chair takes now.
  const auto fewest_on = [&](std::size_t first, std::size_t end) {
    long fewest = 12;
    for (std::size_t k = 0; k < start.parts.size(); ++k) {
      if (start.parts[k].label != arm) continue;
      const auto has = [&](const Sighting& each) { return each.parts[k].present; };
      const auto begin = split->seen.begin();
      fewest = std::min<long>(
          fewest, std::count_if(begin + static_cast<long>(first), begin + static_cast<long>(end), has));
    }
    return fewest;
  };
  // Of the plain ones one arm still finds something at their sides.
  CHECK(fewest_on(0, 6) == 0);
  CHECK(fewest_on(6, 12) == 6);
  const auto least_existence_of_arms = [&](std::size_t side) {
    double least = 1;
    for (const TemplatePart& part : split->templates[side].part_template.parts)
      if (part.label == arm) least = std::min(least, part.existence);
    return least;
  };
  CHECK(least_existence_of_arms(split->sides.front()) < 0.5);
  // Estimated from the fits before these, in which one chair's post, two or three of its points, was missed.
  CHECK(least_existence_of_arms(split->sides.back()) > 0.8);
}

TEST_CASE("parts that are seen otherwise at even odds are proposed to be divided by, once more") {
  Case given;
  add_chairs(given.shapes, "plain", 8, points);
  const TemplateMembers members = given.members();
  const auto even = [](const SplitProposal& each) { return each.at_even_odds; };
  CHECK(std::ranges::count_if(split_proposals(given.parent, members, members, {}), even) == 0);
  TemplateMembers at_even_odds = members;
  for (std::size_t i = 0; i < 4; ++i) at_even_odds.seen[i].parts[1].present = false;
  const auto proposals = split_proposals(given.parent, members, at_even_odds, {});
  const auto found = std::ranges::find_if(proposals, even);
  REQUIRE(found != proposals.end());
  CHECK(std::ranges::count_if(proposals, even) == 1);
  CHECK(one_to_one(found->sides, {0, 0, 0, 0, 1, 1, 1, 1}));
  const auto existence = [&](std::size_t member) {
    return found->templates[found->sides[member]].part_template.parts[1].existence;
  };
  CHECK(existence(0) < 0.5);
  CHECK(existence(7) > 0.5);
}

TEST_CASE("proposals are divisions that leave enough on both sides, once with each kind of child") {
  Case given;
  add_chairs(given.shapes, "plain", 6, points);
  add_chairs(given.shapes, "bench", 6, points);
  add_chairs(given.shapes, "high", 6, points);
  const TemplateMembers members = given.members();
  const auto proposals = split_proposals(given.parent, members, members, {});
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

TEST_CASE("a division needs enough shapes that fit better") {
  Case given;
  add_chairs(given.shapes, "plain", 6, points);
  add_chairs(given.shapes, "bench", 6, points);
  LearnOptions options;
  options.divided_share = 1.1;  // more than there are
  std::optional<TemplateSplit> split;
  REQUIRE(split_template(given.parent, given.members(), {}, options, 2, {}, split));
  CHECK_FALSE(split);
}

TEST_CASE("a division that is cancelled says so, at once and later") {
  Case given;
  add_chairs(given.shapes, "plain", 6, points);
  add_chairs(given.shapes, "bench", 6, points);
  const TemplateMembers members = given.members();
  // Before any fit, among those of the undivided template, and among those of the proposals.
  for (const int after : {0, 18, 60}) {
    std::stop_source source;
    int fits = 0;
    if (after == 0) source.request_stop();
    const JobControl control{source.get_token(), [&](std::size_t, std::size_t, std::string_view) {
                               if (++fits == after) source.request_stop();
                             }};
    std::optional<TemplateSplit> split;
    CHECK_FALSE(split_template(given.parent, members, {}, {}, 1, control, split));
    CHECK(fits <= after + 1);
  }
}
