// What changes the number of templates.
#include <algorithm>
#include <iterator>
#include <set>

#include "core/learning/child_name.h"
#include "core/learning/merge_templates.h"
#include "core/learning/round_in_progress.h"
#include "core/learning/split_template.h"

namespace archetype {

bool RoundInProgress::try_split(std::size_t t) {
  const auto [indices, members] =
      members_of([&](std::size_t i) { return taken_[i].part_template == t && !is_pinned_to(i, t); });
  if (indices.size() < 2 * options_.smallest_cluster) return true;
  const auto judges = std::span(indices).first(members.judging);
  if (about_undivided(result_.templates[t].undivided, judges)) return true;
  result_.templates[t].undivided.assign(judges.begin(), judges.end());
  std::optional<TemplateSplit> split;
  const double least_gain = options_.least_division_gain * static_cast<double>(judging_);
  if (!split_template(result_.templates[t], members, fit_options_, options_, threads_, counted_, split,
                      least_gain))
    return false;
  if (!split) return true;
  const std::string name = result_.templates[t].part_template.name;
  for (std::size_t m = 0; m < indices.size(); ++m) {
    const std::size_t side = split->sides[m];
    taken_[indices[m]] = {side == 0 ? t : result_.templates.size() + side - 1, std::move(split->seen[m])};
  }
  split->templates.front().pinned = result_.templates[t].pinned;
  result_.templates[t] = std::move(split->templates.front());
  result_.origins[t].changed = true;
  for (LearnedTemplate& child : std::span(split->templates).subspan(1)) {
    child.part_template.name = child.initial.name = free_name(name);
    result_.templates.push_back(std::move(child));
    result_.origins.push_back({t, true});
  }
  return see_pinned_again(t);
}

bool RoundInProgress::try_merges() {
  if (std::ranges::any_of(result_.origins, &TemplateOrigin::changed)) return true;
  const std::size_t count = result_.templates.size();
  planned_ = fitted_ + 2 * (count - 1) * shapes_.size();
  for (std::size_t a = 0; a < count; ++a) {
    for (std::size_t b = a + 1; b < count; ++b) {
      if (!try_merge(a, b)) return false;
    }
  }
  return true;
}

RoundInProgress::Chosen RoundInProgress::members_of(const std::function<bool(std::size_t)>& is_member) const {
  Chosen chosen;
  for (std::size_t i = 0; i < shapes_.size(); ++i) {
    if (!is_member(i)) continue;
    chosen.indices.push_back(i);
    chosen.members.shapes.push_back(shapes_[i]);
    chosen.members.seen.push_back(taken_[i].seen);
    chosen.members.judging += i < judging_ ? 1 : 0;
  }
  return chosen;
}

bool RoundInProgress::try_merge(std::size_t a, std::size_t b) {
  if (result_.origins[a].changed || result_.origins[b].changed || result_.templates[b].pinned) return true;
  const auto [indices, members] =
      members_of([&](std::size_t i) { return taken_[i].part_template == a || taken_[i].part_template == b; });
  Sides sides;
  for (const std::size_t i : indices) sides.push_back(taken_[i].part_template == b ? 1 : 0);
  std::optional<TemplateMerge> merge;
  if (!merge_templates(result_.templates[a], result_.templates[b], members, sides, fit_options_, options_,
                       threads_, counted_, merge))
    return false;
  const auto of_b = static_cast<std::size_t>(std::ranges::count(sides, std::size_t{1}));
  const double saved = price(sides.size() - of_b) + price(of_b) - price(sides.size());
  if (!merge || merge->gain + saved <= smallest_gain * static_cast<double>(members.judging)) return true;
  result_.templates[a].part_template = std::move(merge->part_template);
  // It would only be divided again as it was.
  const auto judges = std::span(indices).first(members.judging);
  result_.templates[a].undivided.assign(judges.begin(), judges.end());
  result_.origins[a].changed = true;
  for (std::size_t m = 0; m < indices.size(); ++m) taken_[indices[m]] = {a, std::move(merge->seen[m])};
  return true;
}

bool RoundInProgress::see_pinned_again(std::size_t t) {
  std::vector<std::size_t> indices;
  std::vector<LearningShape> shapes;
  for (std::size_t i = 0; i < shapes_.size(); ++i) {
    if (taken_[i].part_template != t || !is_pinned_to(i, t)) continue;
    indices.push_back(i);
    shapes.push_back(shapes_[i]);
  }
  if (indices.empty()) return true;
  auto seen = sightings(result_.templates[t].part_template, shapes, fit_options_, threads_, counted_);
  if (!seen) return false;
  for (std::size_t k = 0; k < indices.size(); ++k) taken_[indices[k]].seen = std::move((*seen)[k]);
  return true;
}

bool RoundInProgress::about_undivided(std::span<const std::size_t> undivided,
                                      std::span<const std::size_t> judges) const {
  if (undivided.empty()) return false;
  std::vector<std::size_t> changed;
  std::ranges::set_symmetric_difference(undivided, judges, std::back_inserter(changed));
  return static_cast<double>(changed.size()) <=
         options_.cluster_share * static_cast<double>(undivided.size());
}

std::string RoundInProgress::free_name(const std::string& parent) const {
  std::set<std::string> taken;
  for (const LearnedTemplate& each : result_.templates) taken.insert(each.part_template.name);
  return child_name(parent, taken);
}

}  // namespace archetype
