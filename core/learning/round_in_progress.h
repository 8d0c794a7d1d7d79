// A round of learning while it is under way: learning_round.cpp fits the templates and estimates them anew,
// round_siblings.cpp those that have the same parts together, round_divisions.cpp divides and joins them.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <functional>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/learning/learning_round.h"
#include "core/learning/sightings.h"
#include "core/learning/split_proposals.h"

namespace archetype {

// Proposals are judged one after the other, so that each is compared with what was kept before it. What
// returns false was cancelled.
class RoundInProgress {
 public:
  // All as in learning_round().
  RoundInProgress(std::span<const LearnedTemplate> templates, std::span<const ShapeSamples> judging,
                  std::span<const ShapeSamples> others, const FitOptions& fit_options,
                  const LearnOptions& options, unsigned threads, const JobControl& control,
                  std::span<const ShapeCorrection* const> corrections, std::span<const int> known_yaws);

  std::optional<LearningRound> run();

 private:
  // A change that gains less than this for each shape is none.
  static constexpr double smallest_gain = 1e-3;
  // So often at most are siblings estimated one time after the other, and so often mostly.
  static constexpr int most_steps = 8;
  static constexpr std::size_t steps_of_siblings = 4;
  // What a shape says of the template that it takes.
  struct Taken {
    std::size_t part_template = 0;
    Sighting seen;
  };
  struct Chosen {
    std::vector<std::size_t> indices;  // ascending
    TemplateMembers members;
  };
  // Templates that have the same parts, and all shapes that take one of them.
  struct Family {
    std::vector<LearnedTemplate> templates;
    Sides sides;                 // by shape: which of them it takes
    std::vector<Sighting> seen;  // by shape: what it says of that one
  };

  std::optional<int> known_yaw(std::size_t shape) const;
  void set_yaw_costs(std::size_t shape, std::array<double, 4> costs);
  // By template; empty where any may be taken.
  std::vector<bool> allowed_of(std::size_t shape) const;
  bool may_take(std::size_t shape, std::size_t t) const;
  bool is_pinned_to(std::size_t shape, std::size_t t) const;
  bool must_learn(std::size_t shape) const;

  // How many fits are ahead: so many, and those of the divisions that will be tried from template `first` on,
  // as far as it can be told.
  void plan(std::size_t fits, std::size_t first);
  // Once to agree on the yaws, and once with what they cost then.
  bool fit_all();
  // The best of all templates for each of the first `count` shapes. Throws NumericError where a shape has no
  // finite energy with any.
  bool take_best(std::size_t count);
  // Of the judging shapes, with what the templates and their parameters cost.
  double mean_energy() const;
  // What a template that so many shapes take has to be worth, in energy of all judging shapes: what a
  // division has to gain (split_template.h).
  double price(std::size_t members) const;
  // The observations of the shapes that template `t` is learned from, the best fits first: those that fit
  // well, and those that it was said to learn from.
  std::vector<std::vector<PartObservation>> learning_set(std::size_t t) const;
  // Of a template that has no siblings.
  bool try_update(std::size_t t);
  // All templates, those that have the same parts together.
  std::vector<std::vector<std::size_t>> families() const;
  // For each member of template `t` (split_template.h with the proposals that its parts allow), rather too
  // many than too few: for the progress.
  std::size_t fits_of_division(std::size_t t) const;
  // About, for the progress.
  std::size_t fits_of_updates(std::span<const std::vector<std::size_t>> families) const;
  // Estimates `siblings` together from all shapes that take them but outliers, and lets these choose anew,
  // until the energy falls no more, at most most_steps times. Kept if it has fallen, both beside what was
  // known of each and beside what all of their shapes say as one. Differs from the paper, which learns from
  // the best fits: of nine chairs the best seven make all spreads wider, as fewer say less against what was
  // known.
  bool try_siblings(const std::vector<std::size_t>& siblings);
  // By shape of the family: whether it is learned from. All but outliers, which are if that was said.
  std::vector<bool> teaching(const Family& family, const Chosen& chosen) const;
  // Its templates from what its shapes say of them now. Takes the observations.
  void estimate_together(Family& family, const Chosen& chosen) const;
  // The best of the family for each of its shapes. Throws NumericError as take_best() does.
  bool choose_again(Family& family, const std::vector<std::size_t>& siblings, const Chosen& chosen);
  // Of its judging shapes, the first ones, with what the templates cost beside `known`, or each beside its
  // own initial one.
  double family_energy(const Family& family, std::size_t judging, const PartTemplate* known) const;
  // Others may have taken all shapes of a template.
  void drop_unused();

  // One or two more templates for some of the shapes that take `t`. Differs from the paper, which looks for
  // it in the learning set: benches fit a chair badly, and that is what makes them a cluster.
  bool try_split(std::size_t t);
  // Whether two should be one: each pair, once nothing else changes. They become one where that costs less
  // than both are worth: shapes that choose anew may leave three of a kind with a template, which would not
  // have been divided for these.
  bool try_merges();
  // Of two that did not change yet.
  bool try_merge(std::size_t a, std::size_t b);
  // Those that stay with template `t` whatever it becomes.
  bool see_pinned_again(std::size_t t);
  // As many others as make no other cluster make no other division: it would be most of a round's work to
  // find that again.
  bool about_undivided(std::span<const std::size_t> undivided, std::span<const std::size_t> judges) const;
  Chosen members_of(const std::function<bool(std::size_t)>& is_member) const;
  std::string free_name(const std::string& parent) const;

  std::span<const ShapeSamples> judging_samples_;
  std::vector<LearningShape> shapes_;  // the judging ones first
  std::size_t judging_;
  const FitOptions& fit_options_;
  const LearnOptions& options_;
  unsigned threads_;
  const JobControl& control_;
  JobControl counted_;  // counts what is fitted in the whole round
  std::mutex reporting_;
  std::atomic<std::size_t> fitted_ = 0;
  std::atomic<std::size_t> planned_ = 0;  // with those that are still ahead
  std::vector<Taken> taken_;              // by shape: the best so far
  LearningRound result_;
};

}  // namespace archetype
