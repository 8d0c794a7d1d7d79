// Proposals are judged one after the other, so that each is compared with what was kept before it.
#include "core/learning/learning_round.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "core/base/parallel.h"
#include "core/fitting/agreed_yaws.h"
#include "core/fitting/fit_template.h"
#include "core/fitting/template_choice.h"
#include "core/learning/arrangement_clusters.h"
#include "core/learning/reestimate.h"

namespace archetype {

namespace {

// A round that gains less than this is none.
constexpr double smallest_gain = 1e-3;

// What a shape says of the template that it takes.
struct Sighting {
  std::size_t part_template = 0;
  double choice = std::numeric_limits<double>::infinity();
  double energy = 0;
  std::array<double, 4> yaw_energies{};
  std::vector<PartObservation> parts;
};

class Round {
 public:
  Round(std::span<const LearnedTemplate> templates, std::span<const ShapeSamples> judging,
        std::span<const ShapeSamples> others, const FitOptions& fit_options, const LearnOptions& options,
        unsigned threads, const JobControl& control)
      : judging_(judging),
        others_(others),
        fit_options_(fit_options),
        options_(options),
        threads_(threads),
        control_(control) {
    result_.templates.assign(templates.begin(), templates.end());
    for (std::size_t t = 0; t < templates.size(); ++t) result_.origins.push_back({t, false});
  }

  std::optional<LearningRound> run() {
    if (!fit_all()) return std::nullopt;
    result_.energy_before = mean_energy();
    const std::size_t count = result_.templates.size();
    for (std::size_t t = 0; t < count; ++t) {
      if (!try_update(t)) return std::nullopt;
    }
    // A template that still moves would only spawn what it is about to become.
    for (std::size_t t = 0; t < count; ++t) {
      if (!result_.origins[t].changed && !try_children(t)) return std::nullopt;
    }
    drop_unused();
    result_.energy = mean_energy();
    for (std::size_t i = 0; i < judging_.size(); ++i) result_.taken.push_back(taken_[i].part_template);
    return std::move(result_);
  }

 private:
  // All shapes, the judging ones first.
  std::size_t shape_count() const { return judging_.size() + others_.size(); }
  const ShapeSamples& shape(std::size_t i) const {
    return i < judging_.size() ? judging_[i] : others_[i - judging_.size()];
  }

  // One template fitted to the first `count` shapes. False if cancelled.
  bool fit(const PartTemplate& part_template, std::size_t t, std::size_t count,
           std::vector<Sighting>& sightings) const {
    sightings.assign(count, {});
    const JobControl stop_only{control_.stop, control_.report};
    return parallel_for(
               count, threads_, stop_only, "learning",
               [&](std::size_t i) {
                 FitOptions options = fit_options_;
                 if (!yaw_costs_.empty()) options.yaw_costs = yaw_costs_[i];
                 const auto found = fit_template(part_template, shape(i), options, {control_.stop, {}});
                 if (!found) return;
                 const double yaw_cost = options.yaw_costs[static_cast<std::size_t>(found->yaw_quarters)];
                 sightings[i] = {t, choice_energy(*found, part_template, options) + yaw_cost,
                                 found->energy.total(), found->yaw_energies, observe_parts(*found, shape(i))};
               }) &&
           !control_.cancelled();
  }

  bool fit_all() {
    if (!take_best(judging_.size())) return false;
    std::vector<std::array<double, 4>> energies;
    for (const Sighting& each : taken_) energies.push_back(each.yaw_energies);
    const AgreedYaws agreed(judging_, energies);
    yaw_costs_.resize(shape_count());
    return parallel_for(shape_count(), threads_, {control_.stop, {}}, "",
                        [&](std::size_t i) { yaw_costs_[i] = agreed.costs(shape(i)); }) &&
           take_best(shape_count());
  }

  // The best of all templates for each of the first `count` shapes. False if cancelled.
  bool take_best(std::size_t count) {
    taken_.assign(count, {});
    for (std::size_t t = 0; t < result_.templates.size(); ++t) {
      std::vector<Sighting> sightings;
      if (!fit(result_.templates[t].part_template, t, count, sightings)) return false;
      for (std::size_t i = 0; i < count; ++i) {
        if (sightings[i].choice < taken_[i].choice) taken_[i] = std::move(sightings[i]);
      }
    }
    return true;
  }

  // Of the judging shapes, with what the parameters of the templates cost.
  double mean_energy() const {
    if (judging_.empty()) return 0;
    double sum = 0;
    std::vector<std::size_t> members(result_.templates.size(), 0);
    for (std::size_t i = 0; i < judging_.size(); ++i) {
      sum += taken_[i].choice;
      ++members[taken_[i].part_template];
    }
    for (std::size_t t = 0; t < members.size(); ++t)
      sum += cost(result_.templates[t].part_template, members[t]);
    return sum / static_cast<double>(judging_.size());
  }

  // The Bayesian information criterion: energies are negative log likelihoods in units of 2 alpha, and a free
  // parameter costs half the logarithm of the number of shapes. Six means and six spreads a part are free as
  // far as the shapes outweigh what was known before.
  double cost(const PartTemplate& part_template, std::size_t members) const {
    const auto m = static_cast<double>(members);
    const double free = 6 * m / (m + options_.prior_shapes_of_means + 1e-9) +
                        6 * m / (m + options_.prior_shapes_of_spreads + 1e-9);
    return fit_options_.alpha * free * static_cast<double>(part_template.parts.size()) *
           std::log(static_cast<double>(judging_.size()));
  }

  // The observations of the shapes that template `t` is learned from, the best fits first.
  std::vector<std::vector<PartObservation>> learning_set(std::size_t t) const {
    std::vector<const Sighting*> members;
    for (const Sighting& each : taken_) {
      if (each.part_template == t && !each.parts.empty()) members.push_back(&each);
    }
    std::ranges::stable_sort(members, {}, &Sighting::energy);
    std::vector<std::vector<PartObservation>> observed;
    const double share = std::ceil(options_.learning_share * static_cast<double>(members.size()));
    for (const Sighting* each : members) {
      if (static_cast<double>(observed.size()) >= share) break;
      if (each->energy > options_.tau * members.front()->energy) break;
      observed.push_back(each->parts);
    }
    return observed;
  }

  // False if cancelled.
  bool try_update(std::size_t t) {
    const auto observed = learning_set(t);
    if (observed.size() < options_.smallest_cluster) return true;
    LearnedTemplate& learned = result_.templates[t];
    const PartTemplate proposal = reestimate(learned.initial, observed, options_);
    std::vector<Sighting> sightings;
    if (!fit(proposal, t, judging_.size(), sightings)) return false;
    double members = 0;
    double agreeing = 0;
    double gain = 0;
    for (std::size_t i = 0; i < judging_.size(); ++i) {
      if (taken_[i].part_template != t) continue;
      members += 1;
      agreeing += sightings[i].choice < taken_[i].choice ? 1 : 0;
      gain += taken_[i].choice - sightings[i].choice;
    }
    if (members == 0 || agreeing < options_.agreeing_share * members || gain < smallest_gain * members)
      return true;
    learned.part_template = proposal;
    result_.origins[t].changed = true;
    for (std::size_t i = 0; i < judging_.size(); ++i) {
      if (taken_[i].part_template == t || sightings[i].choice < taken_[i].choice)
        taken_[i] = std::move(sightings[i]);
    }
    return true;
  }

  // Templates for the clusters of the shapes that take `t`. Differs from the paper, which looks for them in
  // the learning set: benches fit a chair badly, and that is what makes them a cluster. False if cancelled.
  bool try_children(std::size_t t) {
    std::vector<std::vector<PartObservation>> observed;
    for (const Sighting& each : taken_) {
      if (each.part_template == t && !each.parts.empty()) observed.push_back(each.parts);
    }
    for (const auto& cluster : arrangement_clusters(observed, options_)) {
      const auto share = options_.cluster_share * static_cast<double>(observed.size());
      if (cluster.size() == observed.size() || static_cast<double>(cluster.size()) < share) continue;
      std::vector<std::vector<PartObservation>> members;
      members.reserve(cluster.size());
      for (const std::size_t i : cluster) members.push_back(observed[i]);
      if (!try_child(t, members)) return false;
    }
    return true;
  }

  bool try_child(std::size_t parent, std::vector<std::vector<PartObservation>> members) {
    LearnedTemplate child;
    child.initial = without_absent_parts(result_.templates[parent].initial, members);
    child.part_template = reestimate(child.initial, members, options_);
    child.part_template.name = child.initial.name = free_name(result_.templates[parent].part_template.name);
    const std::size_t t = result_.templates.size();
    std::vector<Sighting> sightings;
    if (!fit(child.part_template, t, judging_.size(), sightings)) return false;
    double gain = -cost(child.part_template, members.size());
    std::size_t moved = 0;
    bool parent_stays = false;
    for (std::size_t i = 0; i < judging_.size(); ++i) {
      if (sightings[i].choice < taken_[i].choice) {
        gain += taken_[i].choice - sightings[i].choice;
        ++moved;
      } else if (taken_[i].part_template == parent) {
        parent_stays = true;
      }
    }
    // One that takes all shapes of its parent is no second template but an update, which try_update()
    // refused.
    if (gain <= 0 || moved < options_.smallest_cluster || !parent_stays) return true;
    result_.templates.push_back(std::move(child));
    result_.origins.push_back({parent, true});
    for (std::size_t i = 0; i < judging_.size(); ++i) {
      if (sightings[i].choice < taken_[i].choice) taken_[i] = std::move(sightings[i]);
    }
    return true;
  }

  // Children may have taken all shapes of their parent.
  void drop_unused() {
    std::vector<std::size_t> members(result_.templates.size(), 0);
    for (std::size_t i = 0; i < judging_.size(); ++i) ++members[taken_[i].part_template];
    std::vector<std::size_t> now(members.size(), 0);
    std::size_t kept = 0;
    for (std::size_t t = 0; t < members.size(); ++t) {
      if (members[t] == 0) {
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
    for (std::size_t i = 0; i < judging_.size(); ++i) taken_[i].part_template = now[taken_[i].part_template];
  }

  // A part that none of the shapes has is not a part of their template. Takes it out of `members` as well.
  static PartTemplate without_absent_parts(const PartTemplate& initial,
                                           std::vector<std::vector<PartObservation>>& members) {
    PartTemplate result = initial;
    for (std::size_t k = result.parts.size(); k-- > 0;) {
      const auto has_it = [k](const auto& shape) { return shape[k].present; };
      if (result.parts[k].must_exist || std::ranges::any_of(members, has_it)) continue;
      result.parts.erase(result.parts.begin() + static_cast<std::ptrdiff_t>(k));
      for (auto& shape : members) shape.erase(shape.begin() + static_cast<std::ptrdiff_t>(k));
    }
    return result;
  }

  std::string free_name(const std::string& parent) const {
    std::set<std::string> taken;
    for (const LearnedTemplate& each : result_.templates) taken.insert(each.part_template.name);
    for (int number = 2;; ++number) {
      std::string name = parent + " " + std::to_string(number);
      if (!taken.contains(name)) return name;
    }
  }

  std::span<const ShapeSamples> judging_;
  std::span<const ShapeSamples> others_;
  const FitOptions& fit_options_;
  const LearnOptions& options_;
  unsigned threads_;
  const JobControl& control_;
  std::vector<std::array<double, 4>> yaw_costs_;  // by shape, once the judging ones agree
  std::vector<Sighting> taken_;                   // by shape: the best so far
  LearningRound result_;
};

}  // namespace

bool LearningRound::changed() const {
  return dropped || std::ranges::any_of(origins, &TemplateOrigin::changed);
}

std::optional<LearningRound> learning_round(std::span<const LearnedTemplate> templates,
                                            std::span<const ShapeSamples> judging,
                                            std::span<const ShapeSamples> others,
                                            const FitOptions& fit_options, const LearnOptions& options,
                                            unsigned threads, const JobControl& control) {
  return Round(templates, judging, others, fit_options, options, threads, control).run();
}

}  // namespace archetype
