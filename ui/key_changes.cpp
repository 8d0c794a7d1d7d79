#include "ui/key_changes.h"

#include <algorithm>

#include "core/base/error.h"
#include "ui/studio.h"

namespace archetype {
namespace {

const Command& known(const Studio& studio, std::string_view name) {
  const Command* command = find_command(studio, name);
  if (!command) throw Error("there is no command \"" + std::string(name) + "\"");
  return *command;
}

// Null: the key is free, or this command's own.
const Command* other_with_key(const Studio& studio, std::string_view name, const std::string& key) {
  const auto found = std::ranges::find_if(studio.commands, [&](const Command& each) {
    return !key.empty() && each.name != name && key_of(studio, each) == key;
  });
  return found == studio.commands.end() ? nullptr : &*found;
}

void assign(Studio& studio, const Command& command, const std::string& key) {
  if (key == command.key)
    studio.settings.keys.erase(std::string(command.name));
  else
    studio.settings.keys[std::string(command.name)] = key;
}

void say_key(Studio& studio, const Command& command) {
  const std::string key = key_of(studio, command);
  say(studio, Severity::note,
      std::string(command.title) + (key.empty() ? " has no key now" : ": the key is " + key + " now"));
}

}  // namespace

void wait_for_key(Studio& studio, std::string_view command) {
  studio.ui.key_change = {};
  studio.ui.key_change.command = known(studio, command).name;
}

bool take_new_key(Studio& studio, const KeyChord& chord) {
  KeyChange& change = studio.ui.key_change;
  if (change.command.empty()) return false;
  if (!studio.ui.help || chord.key == "Escape") {
    change = {};
    return true;
  }
  const Command& command = known(studio, change.command);
  if (const Command* other = other_with_key(studio, command.name, to_string(chord))) {
    change.wanted = chord;
    change.taken_by = other->name;
    return true;
  }
  assign(studio, command, to_string(chord));
  change = {};
  say_key(studio, command);
  return true;
}

void take_key_away(Studio& studio) {
  const KeyChange change = std::exchange(studio.ui.key_change, {});
  if (!change.wanted) return;
  assign(studio, known(studio, change.taken_by), "");
  assign(studio, known(studio, change.command), to_string(*change.wanted));
  say_key(studio, known(studio, change.command));
}

void set_key(Studio& studio, std::string_view name, std::string_view key) {
  const Command& command = known(studio, name);
  const std::optional<KeyChord> chord = parse_chord(key);
  if (!chord && !key.empty())
    throw Error("\"" + std::string(key) + "\" is no key; write one like Ctrl+Shift+D");
  const std::string text = chord ? to_string(*chord) : "";
  if (const Command* other = other_with_key(studio, name, text))
    throw Error(text + " is the key of \"" + std::string(other->title) + "\"");
  assign(studio, command, text);
  say_key(studio, command);
}

bool has_own_key(const Studio& studio, std::string_view command) {
  return studio.settings.keys.contains(std::string(command));
}

void reset_key(Studio& studio, std::string_view name) {
  const Command& command = known(studio, name);
  if (const Command* other = other_with_key(studio, name, std::string(command.key)))
    assign(studio, *other, "");
  assign(studio, command, std::string(command.key));
  say_key(studio, command);
}

}  // namespace archetype
