// What the commands of `archetype` share. Each add_… function describes one command to the parser; the one
// that the user chose ends up in Invocation::run.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <stop_token>

#include "core/io/project.h"

namespace archetype {

namespace exit_code {
inline constexpr int done = 0;
inline constexpr int failed = 1;
inline constexpr int wrong_usage = 2;
inline constexpr int some_refused = 3;
inline constexpr int stopped = 130;
}  // namespace exit_code

struct Invocation {
  std::stop_token stop;
  std::uint64_t seed = 1;
  unsigned threads = 0;  // 0: all
  bool json = false;
  std::function<int()> run;  // returns an exit code
};

// --seed and --threads, which every command takes.
void add_common_options(CLI::App& command, Invocation& invocation);
void add_json_option(CLI::App& command, Invocation& invocation);

void add_import_command(CLI::App& app, Invocation& invocation);
void add_init_command(CLI::App& app, Invocation& invocation);
void add_fit_command(CLI::App& app, Invocation& invocation);
void add_learn_command(CLI::App& app, Invocation& invocation);
void add_evaluate_command(CLI::App& app, Invocation& invocation);
void add_export_command(CLI::App& app, Invocation& invocation);
void add_generate_command(CLI::App& app, Invocation& invocation);
void add_map_command(CLI::App& app, Invocation& invocation);
void add_plot_command(CLI::App& app, Invocation& invocation);
void add_report_command(CLI::App& app, Invocation& invocation);
void add_info_command(CLI::App& app, Invocation& invocation);
void add_help_command(CLI::App& app, Invocation& invocation);

bool has_command(const CLI::App& app, const std::string& name);

// One line each on standard error: "refused: PATH: reason".
void print_refused(const std::vector<RefusedInput>& refused);

}  // namespace archetype
