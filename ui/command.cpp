#include "ui/command.h"

#include <algorithm>

#include "core/base/error.h"
#include "ui/command_groups.h"
#include "ui/studio.h"

namespace archetype {

std::vector<Command> all_commands() {
  std::vector<Command> commands;
  add_file_commands(commands);
  add_edit_commands(commands);
  add_template_commands(commands);
  add_part_list_commands(commands);
  add_part_commands(commands);
  add_point_commands(commands);
  add_view_commands(commands);
  add_clusters_commands(commands);
  add_filter_commands(commands);
  add_cloud_commands(commands);
  add_figure_commands(commands);
  add_strip_commands(commands);
  add_fit_commands(commands);
  add_inspect_commands(commands);
  add_correction_commands(commands);
  add_learning_commands(commands);
  add_plot_commands(commands);
  add_help_commands(commands);
  add_quit_command(commands);
  return commands;
}

const Command* find_command(const Studio& studio, std::string_view name) {
  const auto found = std::find_if(studio.commands.begin(), studio.commands.end(),
                                  [&](const Command& command) { return command.name == name; });
  return found == studio.commands.end() ? nullptr : &*found;
}

std::string why_not(const Studio& studio, const Command& command) {
  return command.why_not ? command.why_not(studio) : "";
}

std::string key_of(const Studio& studio, const Command& command) {
  const auto own = studio.settings.keys.find(std::string(command.name));
  return own == studio.settings.keys.end() ? std::string(command.key) : own->second;
}

bool run_command(Studio& studio, std::string_view name, Arguments arguments) {
  try {
    run_command_or_throw(studio, name, arguments);
    return true;
  } catch (const std::exception& error) {
    say(studio, Severity::error, error.what());
    return false;
  }
}

void run_command_or_throw(Studio& studio, std::string_view name, Arguments arguments) {
  const Command* command = find_command(studio, name);
  if (!command) throw Error("there is no command \"" + std::string(name) + "\"; press F1 for the list");
  if (const std::string reason = why_not(studio, *command); !reason.empty())
    throw Error(std::string(command->title) + ": " + reason);
  command->run(studio, arguments);
}

}  // namespace archetype
