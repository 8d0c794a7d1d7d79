// The menu Help.
#include "core/base/error.h"
#include "ui/command_groups.h"
#include "ui/studio.h"

namespace archetype {
namespace {

void palette_command(Studio& studio, Arguments) {
  studio.ui.palette.open = true;
  studio.ui.palette.newly_open = true;
  studio.ui.palette.query.clear();
  studio.ui.palette.chosen = 0;
}

void set_key_command(Studio& studio, Arguments arguments) {
  if (arguments.empty()) throw Error("expected a command, and its key");
  set_key(studio, arguments[0], arguments.size() > 1 ? arguments[1] : "");
}

void reset_keys_command(Studio& studio, Arguments) {
  studio.settings.keys.clear();
  studio.ui.key_change = {};
  say(studio, Severity::note, "All keys are the default ones");
}

std::string needs_changed_keys(const Studio& studio) {
  return studio.settings.keys.empty() ? "all keys are the default ones" : "";
}

}  // namespace

void add_help_commands(std::vector<Command>& commands) {
  commands.insert(commands.end(), {
                                      {.name = "palette",
                                       .title = "All commands…",
                                       .menu = "Help",
                                       .key = "Ctrl+P",
                                       .run = palette_command},
                                      {.name = "keys",
                                       .title = "Keys",
                                       .menu = "Help",
                                       .key = "F1",
                                       .run = [](Studio& s, Arguments) { s.ui.help = !s.ui.help; }},
                                      {.name = "set-key",
                                       .title = "Set the key of a command",
                                       .arguments = "COMMAND [KEY]",
                                       .run = set_key_command},
                                      {.name = "reset-keys",
                                       .title = "All keys as they were at first",
                                       .menu = "Help",
                                       .run = reset_keys_command,
                                       .why_not = needs_changed_keys},
                                      {.name = "about",
                                       .title = "About and credits",
                                       .menu = "Help",
                                       .run = [](Studio& s, Arguments) { s.ui.about = !s.ui.about; },
                                       .separator = true},
                                  });
}

}  // namespace archetype
