// Proposals are started from cheaply; what is kept is what the division makes of them.
#include "core/learning/split_template.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "core/learning/parameter_cost.h"

namespace archetype {

namespace {

using Observed = std::vector<std::vector<PartObservation>>;

constexpr int divisions = 3;
constexpr std::size_t followed = 4;  // proposals of two and of three that are divided by, the best ones

// The division of the members between several templates.
class Division {
 public:
  Division(const LearnedTemplate& parent, SplitProposal proposal, const TemplateMembers& members)
      : parent_(&parent),
        templates_(std::move(proposal.templates)),
        members_(&members),
        sides_(std::move(proposal.sides)),
        seen_(templates_.size()) {
    seen_.front() = members.seen;
  }

  std::size_t sides() const { return templates_.size(); }

  // By which the choice energies of the judging members fall, less what the parameters cost.
  double gain(const FitOptions& fit_options, const LearnOptions& options) const {
    double sum = 0;
    std::vector<std::size_t> counts(templates_.size(), 0);
    for (std::size_t i = 0; i < members_->judging; ++i) {
      sum += members_->seen[i].choice - seen_[sides_[i]][i].choice;
      ++counts[sides_[i]];
    }
    const PartTemplate& known = parent_->part_template;
    for (std::size_t side = 0; side < templates_.size(); ++side)
      sum -= parameter_cost(templates_[side].part_template, known, counts[side], fit_options, options);
    return sum;
  }

  // So many of the judging members fit better.
  std::size_t agreeing() const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < members_->judging; ++i)
      count += seen_[sides_[i]][i].choice < members_->seen[i].choice ? 1 : 0;
    return count;
  }

  bool balanced(std::size_t least) const {
    for (std::size_t side = 0; side < templates_.size(); ++side) {
      if (static_cast<std::size_t>(std::ranges::count(sides_, side)) < least) return false;
    }
    return true;
  }

  // Estimates all anew from the shapes that take them, and lets every shape take the best one. The children
  // of a proposal are taken as they are at first. False if cancelled. (Proposals compared by their child
  // alone, beside the parent as it is, take a sixth less time, but part fewer collections of lamps.)
  bool advance(const FitOptions& fit_options, const LearnOptions& options, unsigned threads,
               const JobControl& control) {
    for (std::size_t side = 0; side < templates_.size(); ++side) {
      Observed of_side;
      for (std::size_t i = 0; i < sides_.size() && !seen_[side].empty(); ++i) {
        if (sides_[i] == side) of_side.push_back(seen_[side][i].parts);
      }
      LearnedTemplate& each = templates_[side];
      if (!of_side.empty()) each.part_template = reestimate(each.initial, of_side, options);
      auto seen = sightings(each.part_template, members_->shapes, fit_options, threads, control);
      if (!seen) return false;
      seen_[side] = std::move(*seen);
    }
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      sides_[i] = 0;
      for (std::size_t side = 1; side < templates_.size(); ++side)
        if (seen_[side][i].choice < seen_[sides_[i]][i].choice) sides_[i] = side;
    }
    return true;
  }

  TemplateSplit result(double gain) const {
    TemplateSplit split;
    split.templates = templates_;
    split.sides = sides_;
    split.gain = gain;
    for (std::size_t i = 0; i < sides_.size(); ++i) split.seen.push_back(seen_[sides_[i]][i]);
    return split;
  }

 private:
  const LearnedTemplate* parent_;
  std::vector<LearnedTemplate> templates_;
  const TemplateMembers* members_;
  Sides sides_;
  std::vector<std::vector<Sighting>> seen_;  // by template; the children's are empty before advance()
};

// The members with the parts that they are seen to have where what was known of their existence is no
// evidence for them: arms that were taken to be nearly certain are seen on plain chairs, too, and nothing
// would part these from armchairs. Only the parts are new, so that gains are still counted from the fits as
// they are. One fit a member, in the yaw that it has. Nothing if cancelled.
std::optional<TemplateMembers> with_parts_at_even_odds(const LearnedTemplate& parent,
                                                       const TemplateMembers& members,
                                                       const FitOptions& fit_options, unsigned threads,
                                                       const JobControl& control) {
  FitOptions even = fit_options;
  even.odds_weight = 0;
  std::vector<LearningShape> shapes = members.shapes;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const auto yaw = static_cast<std::size_t>(members.seen[i].yaw_quarters);
    const double cost = shapes[i].yaw_costs[yaw];
    shapes[i].yaw_costs.fill(std::numeric_limits<double>::infinity());
    shapes[i].yaw_costs[yaw] = cost;
  }
  const auto seen = sightings(parent.part_template, shapes, even, threads, control);
  if (!seen) return std::nullopt;
  TemplateMembers result = members;
  for (std::size_t i = 0; i < shapes.size(); ++i) result.seen[i].parts = (*seen)[i].parts;
  return result;
}

// By which the choice energies of the judging members fall where the parent is estimated anew from all of
// them. Nothing if cancelled.
std::optional<double> gain_of_whole(const LearnedTemplate& parent, const TemplateMembers& members,
                                    const FitOptions& fit_options, const LearnOptions& options,
                                    unsigned threads, const JobControl& control) {
  Observed all;
  for (const Sighting& each : members.seen) all.push_back(each.parts);
  const PartTemplate estimated = reestimate(parent.part_template, all, options);
  const auto seen =
      sightings(estimated, std::span(members.shapes).first(members.judging), fit_options, threads, control);
  if (!seen) return std::nullopt;
  double gain = 0;
  for (std::size_t i = 0; i < members.judging; ++i)
    gain += std::max(0.0, members.seen[i].choice - (*seen)[i].choice);
  return gain;
}

}  // namespace

bool split_template(const LearnedTemplate& parent, const TemplateMembers& members,
                    const FitOptions& fit_options, const LearnOptions& options, unsigned threads,
                    const JobControl& control, std::optional<TemplateSplit>& split, double least_gain) {
  split.reset();
  const auto even = with_parts_at_even_odds(parent, members, fit_options, threads, control);
  if (!even) return false;
  // What the same estimates gain without any division is no reason for one.
  double without = 0;
  for (const TemplateMembers* each : {&members, &*even}) {
    const auto gained = gain_of_whole(parent, *each, fit_options, options, threads, control);
    if (!gained) return false;
    without = std::max(without, *gained);
  }
  without -= parameter_cost(parent.part_template, parent.initial, members.judging, fit_options, options);
  const auto gain = [&](const Division& division) { return division.gain(fit_options, options) - without; };
  std::vector<Division> started;
  for (SplitProposal& proposal : split_proposals(parent, members, *even, options)) {
    const TemplateMembers& its_members = proposal.at_even_odds ? *even : members;
    Division division(parent, std::move(proposal), its_members);
    if (!division.advance(fit_options, options, threads, control)) return false;
    if (division.balanced(options.smallest_learning_set)) started.push_back(std::move(division));
  }
  std::ranges::stable_sort(started, std::greater<>{}, gain);
  std::array<std::size_t, 4> taken{};  // by the number of sides
  double most = 0;                     // beyond what is needed
  const auto share =
      static_cast<std::size_t>(std::ceil(options.cluster_share * static_cast<double>(members.shapes.size())));
  const double least_agreeing = options.divided_share * static_cast<double>(members.judging);
  for (Division& division : started) {
    if (++taken[division.sides()] > followed) continue;
    for (int step = 1; step < divisions && division.balanced(options.smallest_learning_set); ++step) {
      if (!division.advance(fit_options, options, threads, control)) return false;
    }
    if (!division.balanced(std::max(options.smallest_cluster, share))) continue;
    const double needed = (division.balanced(options.smallest_sure_cluster) ? 1 : 2) * least_gain;
    const double gained = gain(division);
    if (gained - needed <= most || static_cast<double>(division.agreeing()) < least_agreeing) continue;
    most = gained - needed;
    split = division.result(gained);
  }
  return true;
}

}  // namespace archetype
