#include "tests/cli/program.h"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <thread>

#include "tests/support/scratch_folder.h"

namespace archetype::test {

namespace fs = std::filesystem;

namespace {

std::string read_bytes(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

pid_t start(std::vector<std::string> command, const fs::path& out, const fs::path& err) {
  std::vector<char*> argv;
  argv.reserve(command.size() + 1);
  for (std::string& word : command) argv.push_back(word.data());
  argv.push_back(nullptr);
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child != 0) return child;
  dup2(open(out.c_str(), O_WRONLY | O_CREAT, 0600), STDOUT_FILENO);
  dup2(open(err.c_str(), O_WRONLY | O_CREAT, 0600), STDERR_FILENO);
  execv(argv[0], argv.data());
  _exit(127);
}

}  // namespace

Finished run_archetype(const std::vector<std::string>& arguments, std::optional<Signal> signal) {
  using Clock = std::chrono::steady_clock;
  const ScratchFolder folder;
  std::vector<std::string> command{ARCHETYPE_BINARY_DIR "/bin/archetype"};
  command.insert(command.end(), arguments.begin(), arguments.end());
  const pid_t child = start(command, folder.path() / "out", folder.path() / "err");
  auto sent = Clock::now();
  if (signal) {
    std::this_thread::sleep_for(signal->after);
    const auto latest = Clock::now() + std::chrono::minutes(1);
    while (signal->when && !signal->when() && Clock::now() < latest)
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    sent = Clock::now();
    kill(child, signal->number);  // not yet waited for, so it is still this child, if only a dead one
  }
  int status = 0;
  rusage usage{};
  REQUIRE(wait4(child, &status, 0, &usage) == child);
  Finished finished;
  if (WIFEXITED(status)) finished.exit_code = WEXITSTATUS(status);
  finished.out = read_bytes(folder.path() / "out");
  finished.err = read_bytes(folder.path() / "err");
  finished.peak_megabytes = static_cast<double>(usage.ru_maxrss) / 1024;
  finished.seconds_after_signal = std::chrono::duration<double>(Clock::now() - sent).count();
  return finished;
}

void require_run(const std::vector<std::string>& arguments, int exit_code) {
  const Finished run = run_archetype(arguments);
  CAPTURE(run.out);
  CAPTURE(run.err);
  REQUIRE(run.exit_code == exit_code);
}

std::map<std::string, std::string> folder_content(const fs::path& folder) {
  std::map<std::string, std::string> content;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file())
      content[fs::relative(entry.path(), folder).string()] = read_bytes(entry.path());
  }
  return content;
}

}  // namespace archetype::test
