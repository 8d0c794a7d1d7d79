// Templates that have the same parts are estimated together, and their shapes choose anew.
#include <algorithm>
#include <array>
#include <limits>

#include "core/learning/estimate_siblings.h"
#include "core/learning/parameter_cost.h"
#include "core/learning/round_in_progress.h"

namespace archetype {

namespace {

constexpr int most_steps = 8;

}  // namespace

std::vector<std::vector<std::size_t>> RoundInProgress::families() const {
  std::vector<std::vector<std::size_t>> result;
  for (std::size_t t = 0; t < result_.templates.size(); ++t) {
    const auto is_of = [&](const std::vector<std::size_t>& family) {
      return are_siblings(result_.templates[family.front()].part_template,
                          result_.templates[t].part_template);
    };
    const auto family = std::ranges::find_if(result, is_of);
    if (family == result.end())
      result.push_back({t});
    else
      family->push_back(t);
  }
  return result;
}

double RoundInProgress::energy(const Family& family, std::size_t judging, const PartTemplate* known) const {
  double sum = 0;
  std::vector<std::size_t> counts(family.templates.size(), 0);
  for (std::size_t m = 0; m < judging; ++m) {
    sum += family.seen[m].choice;
    ++counts[family.sides[m]];
  }
  for (std::size_t t = 0; t < family.templates.size(); ++t) {
    const LearnedTemplate& each = family.templates[t];
    sum += parameter_cost(each.part_template, known != nullptr ? *known : each.initial, counts[t],
                          fit_options_, options_);
  }
  return sum;
}

bool RoundInProgress::estimate(Family& family, const std::vector<std::size_t>& siblings,
                               const Chosen& chosen) {
  std::vector<std::vector<std::vector<PartObservation>>> observed(siblings.size());
  for (std::size_t m = 0; m < family.seen.size(); ++m)
    observed[family.sides[m]].push_back(std::move(family.seen[m].parts));
  family.templates = estimate_siblings(family.templates, observed, options_);
  family.seen.assign(family.seen.size(), {});
  for (std::size_t t = 0; t < siblings.size(); ++t) {
    auto seen =
        sightings(family.templates[t].part_template, chosen.members.shapes, fit_options_, threads_, counted_);
    if (!seen) return false;
    for (std::size_t m = 0; m < family.seen.size(); ++m) {
      if (!((*seen)[m].choice < family.seen[m].choice) || !may_take(chosen.indices[m], siblings[t])) continue;
      family.sides[m] = t;
      family.seen[m] = std::move((*seen)[m]);
    }
  }
  return true;
}

bool RoundInProgress::try_siblings(const std::vector<std::size_t>& siblings) {
  const auto place = [&](std::size_t t) { return std::ranges::find(siblings, t) - siblings.begin(); };
  const Chosen chosen = members_of(
      [&](std::size_t i) { return std::ranges::find(siblings, taken_[i].part_template) != siblings.end(); });
  Family now;
  for (const std::size_t t : siblings) now.templates.push_back(result_.templates[t]);
  for (const std::size_t i : chosen.indices)
    now.sides.push_back(static_cast<std::size_t>(place(taken_[i].part_template)));
  now.seen = chosen.members.seen;

  std::vector<std::vector<PartObservation>> all;
  for (const Sighting& each : now.seen) all.push_back(each.parts);
  const PartTemplate whole = reestimate(now.templates.front().initial, all, options_);
  const auto energies = [&](const Family& family) {
    return std::array{energy(family, chosen.members.judging, nullptr),
                      energy(family, chosen.members.judging, &whole)};
  };
  const auto before = energies(now);
  double most = smallest_gain * static_cast<double>(chosen.members.judging);
  double last = -std::numeric_limits<double>::infinity();
  std::optional<Family> best;
  for (int step = 0; step < most_steps; ++step) {
    if (!estimate(now, siblings, chosen)) return false;
    const auto after = energies(now);
    const double gain = std::min(before[0] - after[0], before[1] - after[1]);
    if (gain <= last) break;
    last = gain;
    if (gain <= most) continue;
    most = gain;
    best = now;
  }
  if (!best) return true;
  for (std::size_t t = 0; t < siblings.size(); ++t) {
    result_.templates[siblings[t]] = std::move(best->templates[t]);
    result_.origins[siblings[t]].changed = true;
  }
  for (std::size_t m = 0; m < chosen.indices.size(); ++m)
    taken_[chosen.indices[m]] = {siblings[best->sides[m]], std::move(best->seen[m])};
  return true;
}

}  // namespace archetype
