// What the program was asked for, and the loop that does it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace archetype {

struct StudioRequest {
  std::string open;                   // a project, folder, template or shape; empty: what was open last
  std::vector<std::string> settings;  // name=value, for this run
  std::filesystem::path script;
  std::filesystem::path screenshot;
  bool quit = false;
};

// Returns the exit status. Throws Error for what stops the program: no display, a script that cannot be run.
int run_studio(const StudioRequest& request);

}  // namespace archetype
