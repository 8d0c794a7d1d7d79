// The batch program: the same work as the studio's, without a window.
#include <cstdio>
#include <iostream>

#include "app/batch/command.h"
#include "app/batch/interrupt.h"

namespace {

using namespace archetype;

void print_error(const std::string& message) {
  std::fprintf(stderr, "archetype: %s\n", message.c_str());
}

int parse_and_run(int argc, char** argv, Invocation& invocation) {
  CLI::App app("Learns part-based templates from collections of 3D shapes (Kim et al. 2013).", "archetype");
  app.set_version_flag("--version", "archetype " ARCHETYPE_VERSION);
  app.require_subcommand(1);
  app.footer(
      "Exit status: 0 done; 1 failed; 2 wrong usage; 3 done, but some inputs were refused; 130 stopped.");
  add_import_command(app, invocation);
  add_init_command(app, invocation);
  add_learn_command(app, invocation);
  add_fit_command(app, invocation);
  add_evaluate_command(app, invocation);
  add_map_command(app, invocation);
  add_export_command(app, invocation);
  add_report_command(app, invocation);
  add_generate_command(app, invocation);
  add_plot_command(app, invocation);
  add_info_command(app, invocation);
  add_help_command(app, invocation);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help_or_version) {
    return app.exit(help_or_version);
  } catch (const CLI::ParseError& error) {
    if (argc > 1 && argv[1][0] != '-' && !has_command(app, argv[1])) {
      print_error("there is no command " + std::string(argv[1]) + "; see `archetype help`");
      return exit_code::wrong_usage;
    }
    print_error(std::string(error.what()) + "; see `archetype help`");
    return exit_code::wrong_usage;
  }
  const int code = invocation.run();
  if (!std::cout.flush()) {
    print_error("standard output cannot be written; is the disk full?");
    return exit_code::failed;
  }
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  Interrupt interrupt;
  Invocation invocation;
  invocation.stop = interrupt.token();
  try {
    return parse_and_run(argc, argv, invocation);
  } catch (const std::bad_alloc&) {
    print_error("there is not enough memory; use fewer --threads or smaller shapes");
  } catch (const std::exception& error) {
    print_error(error.what());
  }
  return exit_code::failed;
}
