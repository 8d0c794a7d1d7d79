#include "core/fitting/pinned_labels.h"

#include <algorithm>
#include <limits>

#include "core/model/shape_fit.h"

namespace archetype {

std::vector<PinnedLabel> pinned_labels(const PinnedParts& pinned, const PartTemplate& part_template,
                                       std::size_t samples) {
  std::vector<PinnedLabel> result;
  for (const auto& [name, of_part] : pinned) {
    std::int16_t label = null_label;
    if (!name.empty()) {
      const auto part = std::ranges::find(part_template.parts, name, &TemplatePart::name);
      if (part == part_template.parts.end()) continue;
      label = static_cast<std::int16_t>(part - part_template.parts.begin());
    }
    for (const std::uint32_t sample : of_part) {
      if (sample < samples) result.push_back({sample, label});
    }
  }
  std::ranges::stable_sort(result, {}, &PinnedLabel::sample);
  const auto same = [](const PinnedLabel& a, const PinnedLabel& b) { return a.sample == b.sample; };
  result.erase(std::unique(result.begin(), result.end(), same), result.end());
  return result;
}

std::array<double, 4> pinned_yaw_costs(std::array<double, 4> costs, const ShapeCorrection& correction) {
  if (!correction.yaw_quarters) return costs;
  costs.fill(std::numeric_limits<double>::infinity());
  costs[static_cast<std::size_t>(*correction.yaw_quarters & 3)] = 0;
  return costs;
}

std::vector<bool> allowed_templates(const ShapeCorrection& correction,
                                    std::span<const std::string> template_names) {
  std::vector<bool> allowed;
  for (const std::string& name : template_names) allowed.push_back(name == correction.part_template);
  if (std::ranges::find(allowed, true) == allowed.end()) allowed.assign(template_names.size(), true);
  return allowed;
}

bool can_be_heeded(const ShapeCorrection& correction, std::span<const PartTemplate> templates) {
  const std::string& wanted = correction.part_template;
  if (!wanted.empty() && std::ranges::find(templates, wanted, &PartTemplate::name) == templates.end())
    return false;
  return std::ranges::all_of(correction.pinned, [&](const auto& pinned) {
    const std::string& part = pinned.first;
    return part.empty() || std::ranges::any_of(templates, [&](const PartTemplate& each) {
             return std::ranges::find(each.parts, part, &TemplatePart::name) != each.parts.end();
           });
  });
}

}  // namespace archetype
