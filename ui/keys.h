// Keys as people write them: "Ctrl+Shift+Z", "F12", "Delete", "G".
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace archetype {

struct KeyChord {
  std::string key;  // an upper-case letter, a digit, a sign, or a name: "F1", "Escape", "Delete", "Left", …
  bool ctrl = false;
  bool shift = false;
  bool alt = false;
  friend bool operator==(const KeyChord&, const KeyChord&) = default;
};

std::optional<KeyChord> parse_chord(std::string_view text);  // nothing if there is no key in it
std::string to_string(const KeyChord& chord);

// Whether the chord still means a command while a text field has the keyboard: function keys, and Ctrl with a
// letter that no text field uses.
bool works_in_text_fields(const KeyChord& chord);

}  // namespace archetype
