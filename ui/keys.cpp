#include "ui/keys.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace archetype {
namespace {

constexpr std::array named_keys{"Escape", "Enter", "Tab", "Backspace", "Insert",   "Delete", "Right",
                                "Left",   "Down",  "Up",  "PageUp",    "PageDown", "Home",   "End",
                                "Space",  "F1",    "F2",  "F3",        "F4",       "F5",     "F6",
                                "F7",     "F8",    "F9",  "F10",       "F11",      "F12"};

bool equal_ignoring_case(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

std::string canonical_key(std::string_view text) {
  if (text.size() == 1)
    return std::string(1, static_cast<char>(std::toupper(static_cast<unsigned char>(text[0]))));
  for (const char* name : named_keys)
    if (equal_ignoring_case(text, name)) return name;
  return "";
}

}  // namespace

std::optional<KeyChord> parse_chord(std::string_view text) {
  KeyChord chord;
  for (;;) {
    const std::size_t plus = text.find('+');
    if (plus == std::string_view::npos || plus + 1 == text.size()) break;  // the key itself may be "+"
    const std::string_view modifier = text.substr(0, plus);
    if (equal_ignoring_case(modifier, "ctrl"))
      chord.ctrl = true;
    else if (equal_ignoring_case(modifier, "shift"))
      chord.shift = true;
    else if (equal_ignoring_case(modifier, "alt"))
      chord.alt = true;
    else
      return std::nullopt;
    text.remove_prefix(plus + 1);
  }
  chord.key = canonical_key(text);
  if (chord.key.empty()) return std::nullopt;
  return chord;
}

std::string to_string(const KeyChord& chord) {
  return std::string(chord.ctrl ? "Ctrl+" : "") + (chord.alt ? "Alt+" : "") + (chord.shift ? "Shift+" : "") +
         chord.key;
}

bool works_in_text_fields(const KeyChord& chord) {
  constexpr std::string_view of_text_fields = "ACVXYZ";
  if (chord.key.size() > 1) return chord.key[0] == 'F';
  return chord.ctrl && of_text_fields.find(chord.key) == std::string_view::npos;
}

}  // namespace archetype
