#include "core/learning/estimate_siblings.h"

#include <doctest/doctest.h>

#include "tests/support/small_collection.h"

using namespace archetype;

namespace {

using Observed = std::vector<std::vector<PartObservation>>;

// One part, whose centre lies at each of these heights.
Observed at_heights(const std::vector<double>& heights) {
  Observed result;
  for (const double height : heights) {
    PartObservation seen;
    seen.present = true;
    seen.box.centre = {0, height, 0};
    seen.box.half_extent = {1, 1, 1};
    result.push_back({seen});
  }
  return result;
}

LearnedTemplate known_within(double height, double spread) {
  PartTemplate part_template;
  TemplatePart& part = part_template.parts.emplace_back();
  part.name = "seat";
  part.position.mean = {0, height, 0};
  part.position.stddev.setConstant(spread);
  part.scale.mean.setOnes();
  part.scale.stddev.setConstant(0.2);
  return {part_template, part_template};
}

double height_of(const LearnedTemplate& each) {
  return each.part_template.parts[0].position.mean.y();
}
double spread_of(const LearnedTemplate& each) {
  return each.part_template.parts[0].position.stddev.y();
}

}  // namespace

TEST_CASE("siblings have means of their own, and spreads that come of all of them") {
  const std::vector siblings{known_within(0, 0.5), known_within(3, 0.02)};
  const std::vector observed{at_heights({-0.1, 0.1, -0.1, 0.1}), at_heights({3.1, 3.3, 3.1, 3.3})};
  const auto found = estimate_siblings(siblings, observed, {});
  REQUIRE(found.size() == 2);
  CHECK(height_of(found[0]) == doctest::Approx(0).epsilon(0.01));
  // 3.2, which counts as four shapes, from 3, which counts as two, and then once more from there.
  CHECK(found[1].initial.parts[0].position.mean.y() == doctest::Approx(3.2 - 0.2 / 3));
  CHECK(height_of(found[1]) == doctest::Approx(3.2 - 0.2 / 9));
  // They differ alike, whatever was known of them; that they are 3 apart is no spread of either.
  CHECK(spread_of(found[0]) == doctest::Approx(spread_of(found[1])).epsilon(0.01));
  CHECK(spread_of(found[0]) > 0.11);
  CHECK(spread_of(found[0]) < 0.25);
  CHECK(found[1].initial.parts[0].position.stddev == found[0].initial.parts[0].position.stddev);
  // Alone, each would keep more of what was known of it.
  CHECK(reestimate(siblings[0].initial, observed[0], {}).parts[0].position.stddev.y() > spread_of(found[0]));
  CHECK(reestimate(siblings[1].initial, observed[1], {}).parts[0].position.stddev.y() < spread_of(found[1]));
}

TEST_CASE("what is the same on all shapes is not expected more closely with every estimate") {
  std::vector siblings{known_within(0, 0.3), known_within(3, 0.3)};
  const std::vector observed{at_heights({0, 0, 0, 0, 0, 0}), at_heights({3, 3, 3, 3, 3, 3})};
  for (int step = 0; step < 40; ++step) siblings = estimate_siblings(siblings, observed, {});
  CHECK(spread_of(siblings[0]) == LearnOptions{}.smallest_spread);
  CHECK(spread_of(siblings[1]) == LearnOptions{}.smallest_spread);
}

TEST_CASE("a kind that varies more than its siblings still has wider spreads") {
  const std::vector siblings{known_within(0, 0.3), known_within(3, 0.3)};
  const auto found = estimate_siblings(
      siblings, std::vector{at_heights({-0.5, 0.5, -0.5, 0.5}), at_heights({2.95, 3.05, 2.95, 3.05})}, {});
  CHECK(spread_of(found[0]) > 1.3 * spread_of(found[1]));
}

TEST_CASE("a sibling with too few shapes stays as it is, and a part that no shape has where it was") {
  std::vector siblings{known_within(0, 0.5), known_within(3, 0.02)};
  siblings[1].undivided = {1, 2};
  Observed without = at_heights({5, 5, 5});
  for (auto& parts : without) parts[0].present = false;
  const auto found = estimate_siblings(siblings, std::vector{without, at_heights({9, 9})}, {});
  CHECK(found[1].part_template == siblings[1].part_template);
  CHECK(found[1].initial == siblings[1].initial);
  CHECK(found[1].undivided == siblings[1].undivided);
  CHECK(height_of(found[0]) == doctest::Approx(0));
  CHECK(spread_of(found[0]) == doctest::Approx(0.5));
  CHECK(found[0].part_template.parts[0].existence < siblings[0].part_template.parts[0].existence);
}

TEST_CASE("siblings have parts of the same names and labels, in the same order") {
  PartTemplate chair = test::chair_template();
  PartTemplate other = chair;
  other.name = "other";
  other.parts[0].position.mean.setConstant(7);
  CHECK(are_siblings(chair, other));
  std::swap(other.parts[0], other.parts[1]);
  CHECK_FALSE(are_siblings(chair, other));
  other = chair;
  ++other.parts[0].label;
  CHECK_FALSE(are_siblings(chair, other));
  other = chair;
  other.parts.pop_back();
  CHECK_FALSE(are_siblings(chair, other));
}
