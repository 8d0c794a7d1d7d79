// Template files (.json); the format is described in the README.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/model/part_template.h"

namespace archetype {

// What a file may hold. Bounds on sizes and spreads are in normalised shape units (a shape's mean radius is
// 1): far beyond anything that means something, and such that squares and their inverses stay finite.
inline constexpr std::size_t most_template_parts = 256;
inline constexpr double least_template_spread = 1e-9;
inline constexpr double largest_template_value = 1e9;

// A part without a label gets its place in the list as label; whatever else may be absent has the default
// that TemplatePart gives it. Throws InputError (file, the key's path, what was expected). `name` is only
// used in error messages.
PartTemplate parse_template(std::string_view json, const std::filesystem::path& name);
PartTemplate read_template(const std::filesystem::path& path);

// Round trips: parse_template(format_template(t)) == t, to the bit, unknown keys included (sorted by name).
// Throws PreconditionError for a template that could not be read again, such as one with numbers that are not
// finite.
std::string format_template(const PartTemplate& part_template);
// Replaces the file in one step: a crash or a full disk leaves the old one.
void write_template(const std::filesystem::path& path, const PartTemplate& part_template);

}  // namespace archetype
