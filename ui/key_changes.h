// Keys of commands, changed by the person at the window: click a key in the list of keys, press another.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "ui/keys.h"

namespace archetype {

struct Studio;

struct KeyChange {
  std::string command;             // gets the next key that is pressed; "": none waits
  std::optional<KeyChord> wanted;  // was pressed, but is another command's
  std::string taken_by;            // the name of that
};

void wait_for_key(Studio& studio, std::string_view command);
// A key was pressed while a command waits for one. False: none waits, and the key means what it ever does.
bool take_new_key(Studio& studio, const KeyChord& chord);
// The wanted key after all: the command that had it has none from then on.
void take_key_away(Studio& studio);

// `key` as people write it; "": none. Throws Error for what is no key, or the key of another command.
void set_key(Studio& studio, std::string_view command, std::string_view key);
bool has_own_key(const Studio& studio, std::string_view command);
// Back to the default, which is taken from a command that was given it.
void reset_key(Studio& studio, std::string_view command);

}  // namespace archetype
