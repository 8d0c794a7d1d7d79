// What the programs hold does not grow with the collection.
#include <doctest/doctest.h>

#include "core/io/template_file.h"
#include "tests/cli/program.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/small_collection.h"

using namespace archetype::test;

TEST_CASE("four times as many shapes take no more memory to import, learn from, label, measure and export") {
  // Samples of one shape take 22 kB: 360 more of them would be seen. Both collections are larger than
  // what learning draws from them.
  constexpr double most_apart = 4;  // MB
  constexpr std::size_t small = 120;
  constexpr std::size_t large = 480;
  std::map<std::string, std::map<std::size_t, double>> peaks;  // by command and number of shapes
  for (const std::size_t count : {small, large}) {
    const ScratchFolder folder;
    write_chairs(folder.path(), count);
    const std::string project = folder.path() / "p";
    const std::string chair = folder.path() / "chair.json";
    archetype::write_template(chair, chair_template());
    const std::vector<std::vector<std::string>> commands{
        {"import", project, folder.path() / "shapes", "--points", "150"},
        {"learn", project, "--template", chair, "--iterations", "1"},
        {"evaluate", project, "--labels", folder.path() / "labels"},
        {"export", project, "--out", folder.path() / "out"}};
    for (std::vector<std::string> command : commands) {
      command.insert(command.end(), {"--threads", "2"});
      const Finished run = run_archetype(command);
      CAPTURE(run.err);
      REQUIRE(run.exit_code == 0);
      peaks[command.front()][count] = run.peak_megabytes;
    }
  }
  for (const auto& [command, peak] : peaks) {
    CAPTURE(command);
    CAPTURE(peak.at(small));
    CHECK(peak.at(large) - peak.at(small) < most_apart);
  }
}
