// Corrections by hand as text: what a project file holds of them.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/model/shape_correction.h"

namespace archetype {

std::string format_correction(const ShapeCorrection& correction);

// Throws InputError for what no Archetype wrote; `name` is only used in its message.
// parse_correction(format_correction(c)) == c.
ShapeCorrection parse_correction(std::string_view text, const std::filesystem::path& name);

std::string_view to_string(ShapeMark mark);

}  // namespace archetype
