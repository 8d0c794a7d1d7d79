// Fits, votes on yaws, and new estimates; siblings are in round_siblings.cpp, divisions in
// round_divisions.cpp.
#include "core/learning/learning_round.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/fitting/agreed_yaws.h"
#include "core/fitting/pinned_labels.h"
#include "core/learning/parameter_cost.h"
#include "core/learning/reestimate.h"
#include "core/learning/round_in_progress.h"

namespace archetype {

RoundInProgress::RoundInProgress(std::span<const LearnedTemplate> templates,
                                 std::span<const ShapeSamples> judging, std::span<const ShapeSamples> others,
                                 const FitOptions& fit_options, const LearnOptions& options, unsigned threads,
                                 const JobControl& control,
                                 std::span<const ShapeCorrection* const> corrections,
                                 std::span<const int> known_yaws)
    : judging_samples_(judging),
      judging_(judging.size()),
      fit_options_(fit_options),
      options_(options),
      threads_(threads),
      control_(control) {
  for (const ShapeSamples& each : judging) shapes_.push_back({&each});
  for (const ShapeSamples& each : others) shapes_.push_back({&each});
  for (std::size_t i = 0; i < corrections.size(); ++i) shapes_[i].correction = corrections[i];
  result_.yaws.assign(known_yaws.begin(), known_yaws.end());
  for (std::size_t i = 0; i < shapes_.size(); ++i) set_yaw_costs(i, fit_options.yaw_costs);
  counted_.stop = control.stop;
  counted_.report = [this](std::size_t, std::size_t, std::string_view) {
    const std::lock_guard lock(reporting_);  // or a thread that was held up would report an old number
    const std::size_t fitted = ++fitted_;
    control_.progress(fitted, std::max(fitted, planned_.load()), "");
  };
  result_.templates.assign(templates.begin(), templates.end());
  for (std::size_t t = 0; t < templates.size(); ++t) result_.origins.push_back({t, false});
}

std::optional<LearningRound> RoundInProgress::run() {
  planned_ = result_.templates.size() * (judging_ + shapes_.size()) + fits_of_updates(families()) +
             fits_of_division(0) * shapes_.size();
  if (!fit_all()) return std::nullopt;
  result_.energy_before = mean_energy();
  const std::size_t count = result_.templates.size();
  const auto all_families = families();
  for (auto family = all_families.begin(); family != all_families.end(); ++family) {
    plan(fits_of_updates({family, all_families.end()}), 0);
    if (!(family->size() == 1 ? try_update(family->front()) : try_siblings(*family))) return std::nullopt;
  }
  // A template that still moves would only spawn what it is about to become.
  for (std::size_t t = 0; t < count; ++t) {
    plan(0, t);
    if (!result_.origins[t].changed && !try_split(t)) return std::nullopt;
  }
  if (!try_merges()) return std::nullopt;
  result_.energy = mean_energy();
  drop_unused();
  for (std::size_t i = 0; i < judging_; ++i) {
    result_.taken.push_back(taken_[i].part_template);
    result_.misfit += taken_[i].seen.misfit / static_cast<double>(judging_);
    const auto present = std::ranges::count(taken_[i].seen.parts, true, &PartObservation::present);
    result_.parts += static_cast<double>(present) / static_cast<double>(judging_);
  }
  // A bench that a template of chairs reached from the side may have turned for one of its own.
  if (result_.yaws.empty()) {
    for (std::size_t i = 0; i < judging_; ++i) result_.yaws.push_back(taken_[i].seen.yaw_quarters);
  }
  return std::move(result_);
}

std::optional<int> RoundInProgress::known_yaw(std::size_t shape) const {
  return shape < result_.yaws.size() ? std::optional(result_.yaws[shape]) : std::nullopt;
}

void RoundInProgress::set_yaw_costs(std::size_t shape, std::array<double, 4> costs) {
  add_cost_of_turning(costs, known_yaw(shape));
  if (const ShapeCorrection* correction = shapes_[shape].correction)
    costs = pinned_yaw_costs(costs, *correction);
  shapes_[shape].yaw_costs = costs;
}

std::vector<bool> RoundInProgress::allowed_of(std::size_t shape) const {
  const ShapeCorrection* correction = shapes_[shape].correction;
  if (!correction || correction->part_template.empty()) return {};
  std::vector<std::string> names;
  for (const LearnedTemplate& each : result_.templates) names.push_back(each.part_template.name);
  return allowed_templates(*correction, names);
}

bool RoundInProgress::may_take(std::size_t shape, std::size_t t) const {
  const std::vector<bool> allowed = allowed_of(shape);
  return allowed.empty() || allowed[t];
}

bool RoundInProgress::is_pinned_to(std::size_t shape, std::size_t t) const {
  const ShapeCorrection* correction = shapes_[shape].correction;
  return correction && correction->part_template == result_.templates[t].part_template.name;
}

bool RoundInProgress::must_learn(std::size_t shape) const {
  return shapes_[shape].correction && shapes_[shape].correction->mark == ShapeMark::learn;
}

void RoundInProgress::plan(std::size_t fits, std::size_t first) {
  for (std::size_t t = first; t < result_.templates.size(); ++t) {
    std::size_t members = 0;
    std::vector<std::size_t> judges;
    for (std::size_t i = 0; i < taken_.size(); ++i) {
      if (taken_[i].part_template != t || is_pinned_to(i, t)) continue;
      ++members;
      if (i < judging_) judges.push_back(i);
    }
    const bool divided = !result_.origins[t].changed && members >= 2 * options_.smallest_cluster &&
                         !about_undivided(result_.templates[t].undivided, judges);
    if (divided) fits += fits_of_division(t) * members;
  }
  planned_ = fitted_ + fits;
}

std::size_t RoundInProgress::fits_of_updates(std::span<const std::vector<std::size_t>> families) const {
  std::size_t fits = 0;
  for (const auto& family : families)
    fits += family.size() == 1 ? judging_ : steps_of_siblings * family.size() * shapes_.size();
  return fits;
}

std::size_t RoundInProgress::fits_of_division(std::size_t t) const {
  return 90 + 5 * result_.templates[t].part_template.parts.size();
}

bool RoundInProgress::fit_all() {
  if (!take_best(judging_)) return false;
  std::vector<std::array<double, 4>> energies;
  for (std::size_t i = 0; i < judging_; ++i) {
    energies.push_back(taken_[i].seen.yaw_energies);
    add_cost_of_turning(energies.back(), known_yaw(i));
  }
  const AgreedYaws agreed(judging_samples_, energies, control_);
  if (control_.cancelled()) return false;
  std::vector<std::array<double, 4>> votes(shapes_.size());
  const auto ask = [&](std::size_t i) { votes[i] = agreed.costs(*shapes_[i].samples); };
  if (!parallel_for(shapes_.size(), threads_, {control_.stop, {}}, "", ask)) return false;
  for (std::size_t i = 0; i < shapes_.size(); ++i) set_yaw_costs(i, votes[i]);
  return take_best(shapes_.size());
}

bool RoundInProgress::take_best(std::size_t count) {
  taken_.assign(count, {});
  const auto shapes = std::span(shapes_).first(count);
  for (std::size_t t = 0; t < result_.templates.size(); ++t) {
    auto seen = sightings(result_.templates[t].part_template, shapes, fit_options_, threads_, counted_);
    if (!seen) return false;
    for (std::size_t i = 0; i < count; ++i) {
      if ((*seen)[i].choice < taken_[i].seen.choice && may_take(i, t)) taken_[i] = {t, std::move((*seen)[i])};
    }
  }
  for (const Taken& each : taken_)
    if (!std::isfinite(each.seen.choice)) throw NumericError("a shape has a fit of no finite energy");
  return true;
}

double RoundInProgress::mean_energy() const {
  if (judging_ == 0) return 0;
  double sum = 0;
  std::vector<std::size_t> members(result_.templates.size(), 0);
  for (std::size_t i = 0; i < judging_; ++i) {
    sum += taken_[i].seen.choice;
    ++members[taken_[i].part_template];
  }
  for (std::size_t t = 0; t < members.size(); ++t)
    sum += parameter_cost(result_.templates[t].part_template, result_.templates[t].initial, members[t],
                          fit_options_, options_);
  std::vector<std::size_t> all(result_.templates.size(), 0);
  for (const Taken& each : taken_) ++all[each.part_template];
  for (std::size_t t = 0; t < all.size(); ++t) sum += members[t] == 0 ? 0 : price(all[t]);
  return sum / static_cast<double>(judging_);
}

double RoundInProgress::price(std::size_t members) const {
  const double of_sure = options_.least_division_gain * static_cast<double>(judging_);
  return members < options_.smallest_sure_cluster ? 2 * of_sure : of_sure;
}

std::vector<std::vector<PartObservation>> RoundInProgress::learning_set(std::size_t t) const {
  std::vector<std::size_t> members;
  for (std::size_t i = 0; i < taken_.size(); ++i) {
    if (taken_[i].part_template == t) members.push_back(i);
  }
  const auto energy = [this](std::size_t i) { return taken_[i].seen.energy; };
  std::ranges::stable_sort(members, {}, energy);
  std::vector<std::vector<PartObservation>> observed;
  const double share = std::ceil(options_.learning_share * static_cast<double>(members.size()));
  double fit_well = 0;
  for (const std::size_t i : members) {
    const bool fits = fit_well < share && energy(i) <= options_.tau * energy(members.front());
    if (!fits && !must_learn(i)) continue;
    if (fits) fit_well += 1;
    observed.push_back(taken_[i].seen.parts);
  }
  return observed;
}

bool RoundInProgress::try_update(std::size_t t) {
  const auto observed = learning_set(t);
  if (observed.size() < options_.smallest_learning_set) return true;
  LearnedTemplate& learned = result_.templates[t];
  const PartTemplate proposal = reestimate(learned.initial, observed, options_);
  auto seen = sightings(proposal, std::span(shapes_).first(judging_), fit_options_, threads_, counted_);
  if (!seen) return false;
  double members = 0;
  double agreeing = 0;
  double gain = 0;
  for (std::size_t i = 0; i < judging_; ++i) {
    if (taken_[i].part_template != t) continue;
    members += 1;
    agreeing += (*seen)[i].choice < taken_[i].seen.choice ? 1 : 0;
    gain += taken_[i].seen.choice - (*seen)[i].choice;
  }
  if (members == 0 || agreeing < options_.agreeing_share * members || gain < smallest_gain * members)
    return true;
  learned.part_template = proposal;
  learned.undivided.clear();
  result_.origins[t].changed = true;
  for (std::size_t i = 0; i < judging_; ++i) {
    if (taken_[i].part_template == t || ((*seen)[i].choice < taken_[i].seen.choice && may_take(i, t)))
      taken_[i] = {t, std::move((*seen)[i])};
  }
  return true;
}

void RoundInProgress::drop_unused() {
  std::vector<std::size_t> members(result_.templates.size(), 0);
  for (std::size_t i = 0; i < judging_; ++i) ++members[taken_[i].part_template];
  std::vector<std::size_t> now(members.size(), 0);
  std::size_t kept = 0;
  for (std::size_t t = 0; t < members.size(); ++t) {
    if (members[t] == 0 && !result_.templates[t].pinned) {
      result_.dropped = true;
      continue;
    }
    now[t] = kept;
    if (kept != t) result_.templates[kept] = std::move(result_.templates[t]);
    result_.origins[kept] = result_.origins[t];
    ++kept;
  }
  result_.templates.resize(kept);
  result_.origins.resize(kept);
  for (std::size_t i = 0; i < judging_; ++i) taken_[i].part_template = now[taken_[i].part_template];
}

bool LearningRound::changed() const {
  return dropped || std::ranges::any_of(origins, &TemplateOrigin::changed);
}

std::optional<LearningRound> learning_round(std::span<const LearnedTemplate> templates,
                                            std::span<const ShapeSamples> judging,
                                            std::span<const ShapeSamples> others,
                                            const FitOptions& fit_options, const LearnOptions& options,
                                            unsigned threads, const JobControl& control,
                                            std::span<const ShapeCorrection* const> corrections,
                                            std::span<const int> known_yaws) {
  if (templates.empty()) throw PreconditionError("there is no template to learn from");
  if (!known_yaws.empty() && known_yaws.size() != judging.size())
    throw PreconditionError("judging shapes need a known yaw each");
  return RoundInProgress(templates, judging, others, fit_options, options, threads, control, corrections,
                         known_yaws)
      .run();
}

}  // namespace archetype
