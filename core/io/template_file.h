// Template files (.json); the format is described in the README.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/model/part_template.h"

namespace archetype {

// Throws InputError (file, the key's path, what was expected). `name` is only used in error messages.
PartTemplate parse_template(std::string_view json, const std::filesystem::path& name);
PartTemplate read_template(const std::filesystem::path& path);

// Round trips: parse_template(format_template(t)) == t, unknown keys included.
std::string format_template(const PartTemplate& part_template);
// Replaces the file in one step: a crash or a full disk leaves the old one.
void write_template(const std::filesystem::path& path, const PartTemplate& part_template);

}  // namespace archetype
