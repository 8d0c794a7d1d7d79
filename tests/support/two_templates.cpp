#include "tests/support/two_templates.h"

#include <algorithm>
#include <stop_token>

#include "core/learning/sightings.h"
#include "tests/support/made_shapes.h"
#include "tests/support/small_collection.h"

namespace archetype::test {

namespace {

constexpr int points = 300;  // of each shape

}  // namespace

void TwoTemplates::add(const std::string& style, std::size_t count, std::size_t side) {
  add_chairs(shapes, style, count, points);
  sides.resize(shapes.size(), side);
}

void TwoTemplates::add_halves(std::size_t count) {
  add("plain", count, 0);
  std::fill(sides.begin() + static_cast<std::ptrdiff_t>(count / 2), sides.end(), 1);
}

void TwoTemplates::learn() {
  members = {};
  for (const ShapeSamples& each : shapes) members.shapes.push_back({&each, {}});
  members.judging = shapes.size();
  members.seen.resize(shapes.size());
  for (std::size_t side = 0; side < 2; ++side) {
    LearnedTemplate& each = side == 0 ? first : second;
    each = {chair_template(), chair_template()};
    std::vector<std::size_t> indices;
    std::vector<LearningShape> own;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      if (sides[i] != side) continue;
      indices.push_back(i);
      own.push_back(members.shapes[i]);
    }
    std::vector<Sighting> seen;
    for (int step = 0; step < 2; ++step) {
      seen = sightings(each.part_template, own, {}, 2, {}).value();
      std::vector<std::vector<PartObservation>> observed;
      for (const Sighting& one : seen) observed.push_back(one.parts);
      each.part_template = reestimate(each.initial, observed, {});
    }
    seen = sightings(each.part_template, own, {}, 2, {}).value();
    for (std::size_t k = 0; k < indices.size(); ++k) members.seen[indices[k]] = std::move(seen[k]);
  }
}

std::optional<TemplateMerge> TwoTemplates::merge() const {
  std::optional<TemplateMerge> result;
  merge_templates(first, second, members, sides, {}, {}, 2, {}, result);
  return result;
}

JobControl cancelled() {
  std::stop_source source;
  source.request_stop();
  return {source.get_token(), {}};
}

}  // namespace archetype::test
