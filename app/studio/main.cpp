// archetype-studio: the desktop program.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "app/studio/run_studio.h"

int main(int argc, char** argv) {
  constexpr int usage = 2;
  CLI::App app("Learns part-based templates from collections of shapes.", "archetype-studio");
  archetype::StudioRequest request;
  app.add_option("PROJECT|SHAPES_DIR", request.open,
                 "what to open; the seats of Sweet Home 3D where nothing is given");
  app.add_option("--set", request.settings, "a setting for this run: name=value")
      ->expected(1)
      ->take_all()
      ->allow_extra_args(false);
  app.add_option("--script", request.script, "commands to run, one a line; F1 in the window lists them");
  app.add_option("--screenshot", request.screenshot,
                 "write the window to this PNG once script and jobs have ended");
  app.add_flag("--quit", request.quit, "end then; needs no display");
  app.set_version_flag("--version", "archetype-studio " ARCHETYPE_VERSION);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : usage;
  }
  try {
    return archetype::run_studio(request);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "archetype-studio: %s\n", error.what());
    return 1;
  }
}
