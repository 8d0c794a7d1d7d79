// Templates that have the same parts are estimated together, and their shapes choose anew.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/error.h"
#include "core/learning/estimate_siblings.h"
#include "core/learning/parameter_cost.h"
#include "core/learning/round_in_progress.h"

namespace archetype {

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

double RoundInProgress::family_energy(const Family& family, std::size_t judging,
                                      const PartTemplate* known) const {
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

std::vector<bool> RoundInProgress::teaching(const Family& family, const Chosen& chosen) const {
  std::vector<double> least(family.templates.size(), std::numeric_limits<double>::infinity());
  for (std::size_t m = 0; m < family.seen.size(); ++m)
    least[family.sides[m]] = std::min(least[family.sides[m]], family.seen[m].energy);
  std::vector<bool> result;
  for (std::size_t m = 0; m < family.seen.size(); ++m) {
    const double bound = options_.outlier_factor * options_.tau * least[family.sides[m]];
    result.push_back(family.seen[m].energy <= bound || must_learn(chosen.indices[m]));
  }
  return result;
}

void RoundInProgress::estimate_together(Family& family, const Chosen& chosen) const {
  std::vector<std::vector<std::vector<PartObservation>>> observed(family.templates.size());
  const std::vector<bool> teaches = teaching(family, chosen);
  for (std::size_t m = 0; m < family.seen.size(); ++m)
    if (teaches[m]) observed[family.sides[m]].push_back(std::move(family.seen[m].parts));
  family.templates = estimate_siblings(family.templates, observed, options_);
}

bool RoundInProgress::choose_again(Family& family, const std::vector<std::size_t>& siblings,
                                   const Chosen& chosen) {
  family.seen.assign(chosen.indices.size(), {});
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
  for (const Sighting& each : family.seen)
    if (!std::isfinite(each.choice)) throw NumericError("a shape has a fit of no finite energy");
  return true;
}

bool RoundInProgress::try_siblings(const std::vector<std::size_t>& siblings) {
  const auto place = [&](std::size_t t) { return std::ranges::find(siblings, t) - siblings.begin(); };
  const Chosen chosen = members_of(
      [&](std::size_t i) { return std::ranges::find(siblings, taken_[i].part_template) != siblings.end(); });
  const std::size_t judging = chosen.members.judging;
  if (judging == 0) return true;
  Family now;
  for (const std::size_t t : siblings) now.templates.push_back(result_.templates[t]);
  for (const std::size_t i : chosen.indices)
    now.sides.push_back(static_cast<std::size_t>(place(taken_[i].part_template)));
  now.seen = chosen.members.seen;

  // Beside what was known of each, and beside what all their shapes say as one, without which any would be
  // better than those that were there: they are drawn to where their own shapes are.
  std::vector<std::vector<PartObservation>> all;
  const std::vector<bool> teaches = teaching(now, chosen);
  for (std::size_t m = 0; m < now.seen.size(); ++m)
    if (teaches[m]) all.push_back(now.seen[m].parts);
  const PartTemplate whole = reestimate(now.templates.front().initial, all, options_);
  const auto energies = [&](const Family& family) {
    return std::array{family_energy(family, judging, nullptr), family_energy(family, judging, &whole)};
  };
  const auto known_energies = energies(now);
  double gained = 0;
  Family best;
  for (int step = 0; step < most_steps; ++step) {
    estimate_together(now, chosen);
    if (!choose_again(now, siblings, chosen)) return false;
    const auto after = energies(now);
    const double gain = std::min(known_energies[0] - after[0], known_energies[1] - after[1]);
    if (step > 0 && !(gain > gained)) break;
    gained = gain;
    best = now;
  }
  if (!(gained > smallest_gain * static_cast<double>(judging))) return true;
  for (std::size_t t = 0; t < siblings.size(); ++t) {
    const std::size_t own = siblings[t];
    result_.origins[own].changed = best.templates[t].part_template != result_.templates[own].part_template;
    result_.templates[own] = std::move(best.templates[t]);
  }
  for (std::size_t m = 0; m < chosen.indices.size(); ++m)
    taken_[chosen.indices[m]] = {siblings[best.sides[m]], std::move(best.seen[m])};
  return true;
}

}  // namespace archetype
