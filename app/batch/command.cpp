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
  command->add_option("COMMAND", *name, "The command to show");
  command->callback([&app, &invocation, name] {
    invocation.run = [&app, name] {
      std::cout << (name->empty() ? app.help() : app.get_subcommand(*name)->help());
      return exit_code::done;
    };
  });
}

void print_refused(const std::vector<RefusedInput>& refused) {
  for (const RefusedInput& input : refused) {
    std::fprintf(stderr, "refused: %s: %s\n", input.path.c_str(), input.reason.c_str());
  }
}

}  // namespace archetype
