// Results as JSON on standard output.
#pragma once

#include <nlohmann/json.hpp>

#include "core/io/project.h"

namespace archetype {

// Indented; bytes that are not UTF-8 (in file names) become U+FFFD.
void print_json(const nlohmann::ordered_json& json);

// [{"path": …, "reason": …}, …]
nlohmann::ordered_json refused_json(const std::vector<RefusedInput>& refused);

}  // namespace archetype
