// A division of the merged template, compared with the one that is there.
#include "core/learning/redivide_templates.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/learning/parameter_cost.h"

namespace archetype {

namespace {

using Pair = std::array<const LearnedTemplate*, 2>;

bool same_parts_must_exist(const PartTemplate& a, const PartTemplate& b) {
  return std::ranges::equal(a.parts, b.parts, {}, &TemplatePart::must_exist, &TemplatePart::must_exist);
}

void keep_most_sides(TemplateSplit& split, const Sides& before) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < before.size(); ++i) kept += split.sides[i] == before[i] ? 1 : 0;
  if (2 * kept >= before.size()) return;
  std::swap(split.templates[0], split.templates[1]);
  for (std::size_t& side : split.sides) side = 1 - side;
}

// Of the judging members.
std::array<std::size_t, 2> count_sides(const Sides& sides, std::size_t judging) {
  std::array<std::size_t, 2> counts{};
  for (std::size_t i = 0; i < judging; ++i) ++counts[sides[i]];
  return counts;
}

bool is_another(const Sides& sides, const Sides& before, std::size_t judging, std::size_t least) {
  const auto counts = count_sides(sides, judging);
  return std::min(counts[0], counts[1]) >= least &&
         !std::equal(sides.begin(), sides.begin() + static_cast<std::ptrdiff_t>(judging), before.begin());
}

// What does not come of the shapes.
void describe_as(PartTemplate& learned, const PartTemplate& known) {
  learned.name = known.name;
  learned.extra_json = known.extra_json;
  for (std::size_t k = 0; k < learned.parts.size(); ++k) {
    learned.parts[k].mirror = known.parts[k].mirror;
    learned.parts[k].colour = known.parts[k].colour;
    learned.parts[k].extra_json = known.parts[k].extra_json;
  }
}

}  // namespace

bool redivide_templates(const LearnedTemplate& first, const LearnedTemplate& second,
                        const TemplateMembers& members, const Sides& sides, const TemplateMerge& merge,
                        const FitOptions& fit_options, const LearnOptions& options, unsigned threads,
                        const JobControl& control, std::optional<TemplateSplit>& split) {
  split.reset();
  if (!same_parts_must_exist(first.part_template, second.part_template)) return true;
  const LearnedTemplate whole{merge.part_template, first.initial};
  const TemplateMembers of_whole{members.shapes, merge.seen, members.judging};
  std::optional<TemplateSplit> found;
  if (!split_template(whole, of_whole, fit_options, options, threads, control, found, {.most_sides = 2}))
    return false;
  if (!found) return true;
  keep_most_sides(*found, sides);
  if (!is_another(found->sides, sides, members.judging, options.smallest_learning_set)) return true;

  double fallen = 0;
  for (std::size_t i = 0; i < members.judging; ++i) fallen += members.seen[i].choice - found->seen[i].choice;
  const Pair before{&first, &second};
  const Pair after{&found->templates[0], &found->templates[1]};
  // Beside what was known before them, or beside the merged one, without which any would be better than those
  // that were there: they are drawn to where their clusters were found.
  const auto cost = [&](const Pair& pair, const Sides& taken, bool beside_whole) {
    const auto counts = count_sides(taken, members.judging);
    double sum = 0;
    for (std::size_t side = 0; side < 2; ++side)
      sum +=
          parameter_cost(pair[side]->part_template, beside_whole ? whole.part_template : pair[side]->initial,
                         counts[side], fit_options, options);
    return sum;
  };
  const auto saved = [&](bool beside_whole) {
    return cost(before, sides, beside_whole) - cost(after, found->sides, beside_whole);
  };
  found->gain = fallen + std::min(saved(false), saved(true));
  if (found->gain <= 0) return true;
  for (std::size_t side = 0; side < 2; ++side) {
    describe_as(found->templates[side].part_template, before[side]->part_template);
    describe_as(found->templates[side].initial, before[side]->part_template);
  }
  split = std::move(found);
  return true;
}

}  // namespace archetype
