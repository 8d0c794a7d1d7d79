// One table of commands that menus, shortcuts, the palette, the list of keys and scripts share.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace archetype {

struct Studio;

using Arguments = std::span<const std::string>;

struct Command {
  std::string_view name = {};   // for scripts: "add-part"; unique
  std::string_view title = {};  // for people: "Add part"
  std::string_view menu = {};   // the menu that it stands in, in the order of the table; "" for none
  std::string_view key = {};    // the default shortcut, "" for none
  std::string_view arguments =
      {};  // "PATH", "[NAME]": [] may be left out, and then the window asks where it has to
  // Throws Error with a line for a person: what is wrong with the arguments, or why it failed.
  void (*run)(Studio&, Arguments) = nullptr;
  // Why it cannot be used now, as a hint on what to do first; "" if it can.
  std::string (*why_not)(const Studio&) = nullptr;
  bool (*checked)(const Studio&) = nullptr;  // for switches: whether it is on
  bool separator = false;                    // a line above it in its menu
  bool edits = false;                        // it changes the document, by one step that can be undone
  bool at_once = false;                      // a script runs it without waiting for what is still under way
};

// All of them, in the order of the menus.
std::vector<Command> all_commands();

const Command* find_command(const Studio& studio, std::string_view name);
std::string why_not(const Studio& studio, const Command& command);
// The shortcut as the user set it, or the default.
std::string key_of(const Studio& studio, const Command& command);

// Runs it if it can be used. What goes wrong, or why it cannot be used, becomes a message; false then.
bool run_command(Studio& studio, std::string_view name, Arguments arguments = {});
// The same, but throws Error: for scripts.
void run_command_or_throw(Studio& studio, std::string_view name, Arguments arguments);

}  // namespace archetype
