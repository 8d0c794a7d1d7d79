// Ctrl-C, as a person presses it.
#include <doctest/doctest.h>

#include <csignal>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/io/project.h"
#include "tests/cli/program.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/small_collection.h"

using namespace archetype;
using namespace archetype::test;

namespace fs = std::filesystem;

namespace {

struct Chairs {
  ScratchFolder folder;

  explicit Chairs(std::size_t count) { write_chairs(folder.path(), count); }
  std::string path(const std::string& name) const { return (folder.path() / name).string(); }
  // Into a new project.
  void import(int points) const {
    for (const char* ending : {"p", "p-wal", "p-shm"}) fs::remove(path(ending));
    require_run({"import", path("p"), path("shapes"), "--points", std::to_string(points)});
  }
  std::map<std::string, std::string> exported() const {
    fs::remove_all(path("out"));
    require_run({"export", path("p"), "--out", path("out")});
    return folder_content(path("out"));
  }
};

// Of a project that may be written just now; none while it is being created.
std::size_t committed_shapes(const fs::path& path) {
  try {
    return Project::open(path).shape_count();
  } catch (const Error&) {
    return 0;
  }
}

// Runs a command on an imported collection until it has been interrupted so often, each time at any moment of
// it, and then to its end.
void interrupt_often(const Chairs& chairs, const std::vector<std::string>& command, int times) {
  constexpr int points = 60;
  chairs.import(points);
  const Finished undisturbed = run_archetype(command);
  REQUIRE(undisturbed.exit_code == 0);
  const auto expected = chairs.exported();
  RandomStream random(5);
  chairs.import(points);
  for (int interrupted = 0; interrupted < times;) {
    const auto moment = static_cast<std::int64_t>(1000 * random.uniform() * undisturbed.seconds_after_signal);
    const Finished run = run_archetype(command, Signal{SIGINT, std::chrono::milliseconds(moment), {}});
    CAPTURE(moment);
    CAPTURE(run.err);
    if (run.exit_code == 0) {  // it came through
      CHECK((chairs.exported() == expected));
      chairs.import(points);
      continue;
    }
    ++interrupted;
    CHECK(run.exit_code == 130);
    CHECK(run.seconds_after_signal < 1);
  }
  require_run(command);
  CHECK((chairs.exported() == expected));
}

}  // namespace

TEST_CASE("Ctrl-C stops within a second, keeps what is done, and the same command goes on from there") {
  const Chairs chairs(400);
  const std::vector<std::string> import{"import", chairs.path("p"), chairs.path("shapes"), "--points",
                                        "1000"};
  std::size_t imported = 0;
  for (const int number : {SIGINT, SIGTERM}) {
    // However fast the machine is, the signal comes while most shapes are still to be done.
    const auto some_more = [&] {
      return fs::exists(chairs.path("p")) && committed_shapes(chairs.path("p")) >= imported + 10;
    };
    const Finished run = run_archetype(import, Signal{number, {}, some_more});
    CAPTURE(run.err);
    CHECK(run.exit_code == 130);
    CHECK(run.seconds_after_signal < 1.5);  // with some room for a busy machine
    const std::size_t now = committed_shapes(chairs.path("p"));
    CHECK(now >= imported + 10);
    CHECK(now < 400);
    imported = now;
  }
}

TEST_CASE(
    "learning from nothing can be interrupted at any moment, and goes on from there to the same bytes") {
  const Chairs chairs(4);
  interrupt_often(chairs, {"learn", chairs.path("p")}, 6);
}

TEST_CASE("init can be interrupted at any moment, and ends with the same bytes") {
  const Chairs chairs(4);
  interrupt_often(chairs, {"init", chairs.path("p"), "--shapes", "3"}, 4);
}
