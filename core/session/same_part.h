// Which part of one template is which of another.
#pragma once

#include <algorithm>
#include <optional>

#include "core/model/part_template.h"

namespace archetype {

// By name, as the templates that learning spawns keep them; of several of one name that with the same index,
// or else the first. Nothing where there is none of this name.
inline std::optional<std::size_t> find_same_part(const PartTemplate& of, std::size_t part,
                                                 const PartTemplate& in) {
  if (part >= of.parts.size()) return std::nullopt;
  if (part < in.parts.size() && in.parts[part].name == of.parts[part].name) return part;
  const auto found = std::ranges::find(in.parts, of.parts[part].name, &TemplatePart::name);
  if (found == in.parts.end()) return std::nullopt;
  return static_cast<std::size_t>(found - in.parts.begin());
}

}  // namespace archetype
