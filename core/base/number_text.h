// Numbers as text that reads back as the same number, whatever the locale.
#pragma once

#include <array>
#include <charconv>
#include <string>

namespace archetype {

// With as few digits as that takes.
inline std::string number_text(double value) {
  std::array<char, 32> digits{};
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr};
}

}  // namespace archetype
