// Another template of the project beside the active one: its boxes dashed in the view, its differences in a
// panel.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/model/part_template.h"

namespace archetype {

struct Studio;

// The template that the active one is compared with; null where there is none.
std::shared_ptr<const PartTemplate> compared_template(const Studio& studio);

// A part of either, by name.
struct PartDifference {
  std::string name;
  std::optional<std::size_t> here{};   // its place in the active template
  std::optional<std::size_t> there{};  // in the other
  double moved = 0;                    // distance of the centres, normalised units
  double larger = 1;                   // the volume here over the volume there
  double turned_degrees = 0;
};

// In the order of `a`, then those that only `b` has. Parts of one name are paired in their order.
std::vector<PartDifference> compare_templates(const PartTemplate& a, const PartTemplate& b);

}  // namespace archetype
