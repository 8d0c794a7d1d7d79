// Options that every command takes, and `archetype help`.
#include "app/batch/command.h"

#include <cstdio>
#include <iostream>

namespace archetype {

void add_common_options(CLI::App& command, Invocation& invocation) {
  command.add_option("--seed", invocation.seed, "Seed of all random choices")->capture_default_str();
  command.add_option("--threads", invocation.threads, "Threads to use (0: all)")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
}

void add_json_option(CLI::App& command, Invocation& invocation) {
  command.add_flag("--json", invocation.json, "Write the result as JSON");
}

void add_help_command(CLI::App& app, Invocation& invocation) {
  CLI::App* command = app.add_subcommand("help", "Show this page, or that of a command");
  const auto name = std::make_shared<std::string>();
  command->add_option("COMMAND", *name, "The command to show")->check([&app](const std::string& text) {
    return has_command(app, text) ? std::string() : "there is no command " + text;
  });
  command->callback([&app, &invocation, name] {
    invocation.run = [&app, name] {
      app.clear();  // the parser shows the page of the command that it has parsed
      std::cout << (name->empty() ? app.help("", CLI::AppFormatMode::All)
                                  : app.get_subcommand(*name)->help("archetype"));
      return exit_code::done;
    };
  });
}

bool has_command(const CLI::App& app, const std::string& name) {
  return !app.get_subcommands([&](const CLI::App* command) { return command->get_name() == name; }).empty();
}

void print_refused(const std::vector<RefusedInput>& refused) {
  for (const RefusedInput& input : refused) {
    std::fprintf(stderr, "refused: %s: %s\n", input.path.c_str(), input.reason.c_str());
  }
}

}  // namespace archetype
