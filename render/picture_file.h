// Pictures to PNG files.
#pragma once

#include <filesystem>

#include "core/base/picture.h"

namespace archetype {

// Throws FileError if the file cannot be written whole. The same picture gives the same bytes.
void write_png(const std::filesystem::path& path, const Picture& picture);

}  // namespace archetype
