// `archetype plot`: each plot of a small project, and what it says where something is missing.
#include <doctest/doctest.h>

#include <algorithm>

#include "core/io/file.h"
#include "core/io/template_file.h"
#include "core/report/plot_catalog.h"
#include "core/session/measure_starts.h"
#include "tests/cli/program.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/small_collection.h"

using namespace archetype;
using namespace archetype::test;

namespace {

struct Fixture {
  ScratchFolder folder;
  std::string project = (folder.path() / "p.archetype").string();
  std::string labels = (folder.path() / "labels").string();
  std::string landmarks = (folder.path() / "landmarks").string();
  std::string out = (folder.path() / "plot.svg").string();
};

}  // namespace

TEST_CASE("every plot is written, and the same twice") {
  const Fixture fixture;
  write_chairs(fixture.folder.path(), 5);
  write_template(fixture.folder.path() / "chair.json", chair_template());
  require_run({"import", fixture.project, (fixture.folder.path() / "shapes").string(), "--points", "100"});
  require_run({"learn", fixture.project, "--template", (fixture.folder.path() / "chair.json").string(),
               "--iterations", "1"});
  for (const PlotEntry& entry : plot_catalog()) {
    CAPTURE(std::string(entry.name));
    const std::vector<std::string> arguments{"plot",        fixture.project,  "--plot",   entry.name,
                                             "--out",       fixture.out,      "--labels", fixture.labels,
                                             "--landmarks", fixture.landmarks};
    require_run(arguments);
    const std::string svg = read_file(fixture.out);
    CHECK(svg.starts_with("<?xml"));
    CHECK(svg.ends_with("</svg>\n"));
    require_run(arguments);
    CHECK(read_file(fixture.out) == svg);
  }
  const std::string csv = (fixture.folder.path() / "back.csv").string();
  require_run({"plot", fixture.project, "--plot", "part-parameters", "--part", "back", "--out", csv});
  CHECK(read_file(csv).starts_with("plot,series,x,y,note\n"));
  const Finished run =
      run_archetype({"plot", fixture.project, "--plot", "part-parameters", "--part", "wing", "--out", csv});
  CHECK(run.exit_code == 1);
  CHECK(run.err.find("wing") != std::string::npos);
}

TEST_CASE("what was measured against other labels is not taken for what these say") {
  const Fixture fixture;
  write_chairs(fixture.folder.path(), 2);
  require_run({"import", fixture.project, (fixture.folder.path() / "shapes").string(), "--points", "100"});
  const auto other = fixture.folder.path() / "other";
  std::filesystem::create_directory(other);
  for (const auto& entry : std::filesystem::directory_iterator(fixture.labels)) {
    std::string of_one;  // as if each shape were of one part
    for (const char each : read_file(entry.path())) of_one += each == '\n' ? "0\n" : "";
    replace_file(other / entry.path().filename(), of_one);
  }
  const auto csv_with = [&](const std::string& labels) {
    const std::string csv = (fixture.folder.path() / "starts.csv").string();
    require_run({"plot", fixture.project, "--plot", "learning-starts", "--out", csv, "--labels", labels});
    return read_file(csv);
  };
  CHECK(csv_with(fixture.labels).find("Labels right") != std::string::npos);
  {
    Project project = Project::open(fixture.project);
    std::vector<StartMeasure> measures = stored_start_measures(project);
    REQUIRE_FALSE(measures.empty());
    measures.front().energy_after = 1234;
    store_start_measures(project, measures);
  }
  CHECK(csv_with(fixture.labels).find("1234") != std::string::npos);
  CHECK(csv_with(other.string()).find("1234") == std::string::npos);
  CHECK(stored_start_measures(Project::open(fixture.project)).front().truth.labels == other);
}

TEST_CASE("a plot that cannot be made says what is missing, in one line") {
  const Fixture fixture;
  write_chairs(fixture.folder.path(), 2);
  require_run({"import", fixture.project, (fixture.folder.path() / "shapes").string(), "--points", "100"});
  for (const PlotEntry& entry : plot_catalog()) {
    CAPTURE(std::string(entry.name));
    const Finished run = run_archetype({"plot", fixture.project, "--plot", entry.name, "--out", fixture.out});
    if (entry.need == PlotNeed::starts) {  // suggests its templates itself: shapes are all it needs
      CHECK(run.exit_code == 0);
      CHECK(std::filesystem::remove(fixture.out));
      continue;
    }
    CHECK(run.exit_code == 1);
    CHECK(run.err.starts_with("archetype: "));
    CHECK(std::ranges::count(run.err, '\n') == 1);
    CHECK_FALSE(std::filesystem::exists(fixture.out));
  }
  CHECK(run_archetype({"plot", fixture.project, "--plot", "nothing", "--out", fixture.out}).exit_code == 2);
  CHECK(run_archetype({"plot", fixture.project, "--plot", "members", "--out", "plot.png"}).exit_code == 2);
  CHECK(run_archetype({"plot", fixture.project, "--plot", "members"}).exit_code == 2);
}
