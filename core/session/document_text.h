// The document as text, to be kept in the project file: what was edited survives a crash.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/session/document.h"

namespace archetype {

std::string format_document(const Document& document);

// Throws InputError; `name` is only used in its message. parse_document(format_document(d)) == d, but for
// what was corrected of single shapes, which has a table of its own in the project file.
Document parse_document(std::string_view text, const std::filesystem::path& name);

}  // namespace archetype
