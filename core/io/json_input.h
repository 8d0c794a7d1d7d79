// JSON from files of unknown origin, made safe to work with.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string_view>

namespace archetype {

// Deeper nesting is refused: code that walks over a document may recurse.
inline constexpr int max_json_depth = 64;

// Keys come sorted: the library's type that keeps their order takes quadratic time for many. Throws
// InputError with line and column for what is no JSON, or is nested deeper than `max_depth`.
nlohmann::json parse_json(std::string_view text, const std::filesystem::path& file,
                          int max_depth = max_json_depth);

}  // namespace archetype
