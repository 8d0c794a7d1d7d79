// The opposite of a division.
#include "core/learning/merge_templates.h"

#include "core/learning/estimate_siblings.h"
#include "core/learning/parameter_cost.h"

namespace archetype {

namespace {

constexpr int steps = 2;

}  // namespace

bool merge_templates(const LearnedTemplate& first, const LearnedTemplate& second,
                     const TemplateMembers& members, const Sides& sides, const FitOptions& fit_options,
                     const LearnOptions& options, unsigned threads, const JobControl& control,
                     std::optional<TemplateMerge>& merge) {
  merge.reset();
  if (!are_siblings(first.part_template, second.part_template)) return true;
  std::size_t of_second = 0;
  for (std::size_t i = 0; i < members.judging; ++i) of_second += sides[i];
  if (of_second == 0 || of_second == members.judging) return true;
  TemplateMerge result;
  result.seen = members.seen;
  for (int step = 0; step < steps; ++step) {
    std::vector<std::vector<PartObservation>> observed;
    for (Sighting& each : result.seen) observed.push_back(std::move(each.parts));
    result.part_template = reestimate(first.initial, observed, options);
    auto seen = sightings(result.part_template, members.shapes, fit_options, threads, control);
    if (!seen) return false;
    result.seen = std::move(*seen);
  }
  const auto cost = [&](const PartTemplate& each, const PartTemplate& known, std::size_t count) {
    return parameter_cost(each, known, count, fit_options, options);
  };
  for (std::size_t i = 0; i < members.judging; ++i)
    result.gain += members.seen[i].choice - result.seen[i].choice;
  result.gain += cost(first.part_template, first.initial, members.judging - of_second) +
                 cost(second.part_template, second.initial, of_second) -
                 cost(result.part_template, first.initial, members.judging);
  merge = std::move(result);
  return true;
}

}  // namespace archetype
