// The menu Help.
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
                                      {.name = "about",
                                       .title = "About and credits",
                                       .menu = "Help",
                                       .run = [](Studio& s, Arguments) { s.ui.about = !s.ui.about; },
                                       .separator = true},
                                  });
}

}  // namespace archetype
