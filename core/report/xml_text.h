// Texts of strangers in XML and HTML.
#pragma once

#include <string>
#include <string_view>

namespace archetype {

// As it may stand between tags and in quoted attributes: markup is escaped; bytes that are no UTF-8, and
// characters that XML 1.0 forbids even escaped, become U+FFFD.
std::string xml_text(std::string_view text);

}  // namespace archetype
