// Which template and yaw a shape takes of all that were tried, and why.
#include <algorithm>
#include <cmath>

#include "core/fitting/pinned_labels.h"
#include "core/session/fit_state.h"
#include "ui/inspection.h"

namespace archetype {
namespace {

std::string name_of(const Alternatives& alternatives, const FitAlternative& each) {
  return alternatives.templates[each.part_template]->name + " at " +
         std::to_string(each.fit.yaw_quarters * 90) + "°";
}

std::vector<bool> allowed_by(const Alternatives& alternatives, const ShapeCorrection& correction) {
  std::vector<std::string> names;
  for (const auto& each : alternatives.templates) names.push_back(each->name);
  return allowed_templates(correction, names);
}

// Null without alternatives.
const FitAlternative* least_of(const Alternatives& alternatives, const ShapeCorrection& correction) {
  const auto energy = [&](const FitAlternative& each) {
    return deciding_energy(alternatives, each, correction);
  };
  const auto least = std::ranges::min_element(alternatives.fits, {}, energy);
  return least == alternatives.fits.end() ? nullptr : &*least;
}

std::string why_not_least(const Alternatives& alternatives, const ShapeCorrection& correction,
                          const FitAlternative& least, const FitAlternative& decided) {
  const std::string begin =
      name_of(alternatives, least) + " has less than " + name_of(alternatives, decided) + ", but ";
  const bool other_yaw = correction.yaw_quarters && *correction.yaw_quarters != least.fit.yaw_quarters;
  if (other_yaw || !allowed_by(alternatives, correction)[least.part_template])
    return begin + "is not what was pinned.";
  if (!alternatives.yaw_costs)
    return begin + "other shapes voted on the yaw, and how is not kept: fit all shapes anew to see it.";
  return begin +
         "each template takes its yaw before it leaves out parts that the shape lacks and is fitted once "
         "more.";
}

}  // namespace

double deciding_energy(const Alternatives& alternatives, const FitAlternative& alternative,
                       const ShapeCorrection& correction) {
  if (!alternatives.yaw_costs || correction.yaw_quarters) return alternative.choice;
  return alternative.choice +
         (*alternatives.yaw_costs)[static_cast<std::size_t>(alternative.fit.yaw_quarters)];
}

const FitAlternative* decided_alternative(const Alternatives& alternatives,
                                          const ShapeCorrection& correction) {
  const InspectedShape& shape = *alternatives.of.shape;
  const std::vector<bool> allowed = allowed_by(alternatives, correction);
  std::optional<int> yaw = correction.yaw_quarters;
  if (!yaw && !alternatives.yaw_costs && shape.fit) yaw = shape.fit->fit.yaw_quarters;
  // fit_template() takes the yaw by the energies that the parts reach together, before it leaves any out but
  // the rarest, or tries once more.
  const auto cost_of_yaw = [&](const FitAlternative& each) {
    const auto quarter = static_cast<std::size_t>(each.fit.yaw_quarters);
    const bool votes = alternatives.yaw_costs && !yaw;
    return each.fit.yaw_energies[quarter] + (votes ? (*alternatives.yaw_costs)[quarter] : 0);
  };
  std::vector<const FitAlternative*> best_yaws(allowed.size(), nullptr);
  for (const FitAlternative& each : alternatives.fits) {
    if (!allowed[each.part_template] || (yaw && each.fit.yaw_quarters != *yaw)) continue;
    const FitAlternative*& best = best_yaws[each.part_template];
    if (!best || cost_of_yaw(each) < cost_of_yaw(*best)) best = &each;
  }
  const FitAlternative* decided = nullptr;
  const auto energy = [&](const FitAlternative* each) {
    return deciding_energy(alternatives, *each, correction);
  };
  for (const FitAlternative* each : best_yaws)
    if (each && (!decided || energy(each) < energy(decided))) decided = each;
  return decided;
}

std::string why_decided(const Alternatives& alternatives, const ShapeCorrection& correction) {
  const FitAlternative* decided = decided_alternative(alternatives, correction);
  const FitAlternative* least = least_of(alternatives, correction);
  if (!decided || !least) return least ? "None of these is what was pinned." : "";
  std::string text;
  if (deciding_energy(alternatives, *least, correction) < deciding_energy(alternatives, *decided, correction))
    text = why_not_least(alternatives, correction, *least, *decided);
  const InspectedShape& shape = *alternatives.of.shape;
  if (!shape.fit) return text;
  const auto add = [&](const std::string& sentence) { text += (text.empty() ? "" : " ") + sentence; };
  const bool current = shape.fit->state == corrected_fit_state(shape.state, &correction);
  const bool is_decided = shape.templates[decided->part_template].id == shape.fit->part_template &&
                          decided->fit.yaw_quarters == shape.fit->fit.yaw_quarters;
  if (!current)
    add("The fit of the project is older than what was pinned, or than the templates.");
  else if (!is_decided)
    add("The fit of the project is another one: it was found with other votes on the yaw.");
  if (shape.fit->status == FitStatus::outlier && correction.mark == ShapeMark::outlier)
    add("It was marked as an outlier by hand.");
  else if (shape.fit->status == FitStatus::outlier)
    add("An outlier: its energy is beyond twice that of all shapes that its template was learned from.");
  return text;
}

}  // namespace archetype
