// Runs the batch program as a user does.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace archetype::test {

struct Finished {
  int exit_code = -1;  // -1: ended by a signal
  std::string out;
  std::string err;
  double seconds_after_signal = 0;  // or from the start, if none was sent
  double peak_megabytes = 0;        // of resident memory
};

struct Signal {
  int number = 0;
  std::chrono::milliseconds after{0};
  std::function<bool()> when;  // if set, asked from then on and waited for, a minute at most
};

// `archetype ARGUMENTS…` from the build that the test belongs to; with `signal`, that is sent if it still
// runs then.
Finished run_archetype(const std::vector<std::string>& arguments, std::optional<Signal> signal = {});

// Fails the test with what the program said unless it ended with `exit_code`.
void require_run(const std::vector<std::string>& arguments, int exit_code = 0);

// The bytes of all files below a folder, by their path in it.
std::map<std::string, std::string> folder_content(const std::filesystem::path& folder);

}  // namespace archetype::test
