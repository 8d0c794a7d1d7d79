// What several parts are called together.
#pragma once

#include <span>
#include <string>

namespace archetype {

// The words that all names begin with: "leg" for "leg front left" and "leg back right"; the first name where
// there are none. Empty for no names.
std::string common_part_name(std::span<const std::string> names);

}  // namespace archetype
