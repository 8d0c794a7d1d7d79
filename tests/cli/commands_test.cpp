// Each command once, its exit codes and what it says.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/base/number_text.h"
#include "core/io/file.h"
#include "core/io/project.h"
#include "core/io/read_shape.h"
#include "core/io/template_file.h"
#include "tests/cli/program.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/small_collection.h"

using namespace archetype::test;

namespace {

struct Fixture {
  ScratchFolder folder;
  std::string project = (folder.path() / "p.archetype").string();
  std::string shapes = (folder.path() / "shapes").string();
  std::string labels = (folder.path() / "labels").string();
  std::string chair = (folder.path() / "chair.json").string();

  explicit Fixture(std::size_t count = 4) {
    write_chairs(folder.path(), count);
    archetype::write_template(chair, chair_template());
  }
  Finished fit() const {
    return run_archetype({"fit", project, "--points", "100", "--template", chair, shapes});
  }
};

bool is_one_line(const std::string& text) {
  return std::ranges::count(text, '\n') == 1 && text.back() == '\n';
}

}  // namespace

TEST_CASE("shapes are imported, fitted, evaluated, exported and described") {
  const Fixture fixture;
  Finished run = run_archetype({"import", fixture.project, fixture.shapes, "--points", "100", "--json"});
  CHECK(run.exit_code == 0);
  CHECK(nlohmann::json::parse(run.out).at("imported") == 4);

  run = run_archetype({"fit", fixture.project, "--template", fixture.chair});
  CHECK(run.exit_code == 0);
  CHECK(run.out == "fitted 4, kept 0, refused 0\n");

  run = run_archetype({"evaluate", fixture.project, "--labels", fixture.labels});
  CHECK(run.exit_code == 0);
  CHECK(run.out.find("mean over 4 shapes") != std::string::npos);
  run = run_archetype({"evaluate", fixture.project, "--labels", fixture.labels, "--json"});
  const auto report = nlohmann::json::parse(run.out);
  CHECK(report.at("shapes").size() == 4);
  CHECK(report.at("shapes")[0].at("own_by_area") <= report.at("shapes")[3].at("own_by_area"));
  CHECK(report.at("mean").at("own_by_area") > 0.7);

  run = run_archetype({"info", fixture.project, "--json"});
  CHECK(nlohmann::json::parse(run.out).at("labelled") == 4);
  run = run_archetype({"info", fixture.project});
  CHECK(run.out.find("chair") != std::string::npos);

  const auto out = fixture.folder.path() / "out";
  require_run({"export", fixture.project, "--out", out.string()});
  const auto files = folder_content(out);
  CHECK(files.size() == 4 + 4 + 5);
  CHECK(files.contains("templates/chair.json"));
  CHECK(files.contains("labels/chair_00000.seg"));
  CHECK(nlohmann::json::parse(files.at("manifest.json")).at("counts").at("fitted") == 4);
  const auto only = fixture.folder.path() / "only";
  require_run({"export", fixture.project, "--only", "fits,boxes", "--out", only.string()});
  CHECK(folder_content(only).size() == 3);
}

TEST_CASE("a report is one page, with the accuracy where labels are given") {
  const Fixture fixture(2);
  CHECK(fixture.fit().exit_code == 0);
  const auto out = fixture.folder.path() / "report.html";
  Finished run =
      run_archetype({"report", fixture.project, "--out", out.string(), "--labels", fixture.labels});
  CHECK(run.exit_code == 0);
  CHECK(is_one_line(run.out));
  const std::string page = archetype::read_file(out);
  CHECK(page.find("chair_00001") != std::string::npos);
  CHECK(page.find("mean over 2 shapes") != std::string::npos);
  run = run_archetype({"report", fixture.project, "--out", out.string(), "--json"});
  CHECK(nlohmann::json::parse(run.out).at("pictures") == 4);
  CHECK(archetype::read_file(out).find("id=\"accuracy\"") == std::string::npos);
  CHECK(run_archetype({"report", fixture.project}).exit_code == 2);
  CHECK(run_archetype({"report", fixture.project, "--out", "/no/such/folder/r.html"}).exit_code == 1);
}

TEST_CASE("an export tells the seed of the samples, energies that add up, and files by the shapes' names") {
  const Fixture fixture(1);
  const std::string odd = "a:b \"c\" (1)";
  std::filesystem::rename(fixture.shapes + "/chair_00000.off", fixture.shapes + "/" + odd + ".off");
  require_run({"import", fixture.project, fixture.shapes, "--points", "100", "--seed", "7"});
  require_run({"fit", fixture.project, "--template", fixture.chair});
  const auto out = fixture.folder.path() / "out";
  require_run({"export", fixture.project, "--out", out.string()});
  const auto files = folder_content(out);
  CHECK(nlohmann::json::parse(files.at("manifest.json")).at("seed") == 7);
  CHECK(files.contains("labels/" + odd + ".seg"));
  const Finished run =
      run_archetype({"evaluate", fixture.project, "--labels", (out / "labels").string(), "--json"});
  CHECK(nlohmann::json::parse(run.out).at("shapes").size() == 1);

  // shape,template,yaw_degrees,energy,e_data,e_deform,e_smooth,e_feature,status,e_exist
  const std::string& table = files.at("fits.csv");
  const std::string row = table.substr(table.find('\n') + 1);
  std::istringstream rest(row.substr(row.find("chair,")));
  std::vector<std::string> cells;
  for (std::string cell; std::getline(rest, cell, ',');) cells.push_back(cell);
  REQUIRE(cells.size() == 9);
  CHECK(std::stod(cells[2]) == doctest::Approx(std::stod(cells[3]) + std::stod(cells[4]) +
                                               std::stod(cells[5]) + std::stod(cells[8])));
}

TEST_CASE("shapes of any yaw are fitted, and the export tells how they stand to their template") {
  const Fixture fixture(1);
  const auto made = fixture.folder.path() / "any";
  require_run(
      {"generate", "chairs", "--count", "4", "--style", "plain", "--yaw", "any", "--out", made.string()});
  require_run({"import", fixture.project, (made / "shapes").string(), "--points", "300"});
  require_run({"fit", fixture.project, "--template", fixture.chair});
  const auto out = fixture.folder.path() / "out";
  require_run({"export", fixture.project, "--out", out.string()});
  // Both tables begin with the shape, something else, and its yaw.
  const auto yaws = [](const std::string& table) {
    std::map<std::string, double> result;
    std::istringstream lines(table.substr(table.find('\n') + 1));
    for (std::string line; std::getline(lines, line);) {
      const auto first = line.find(',');
      result[line.substr(0, first)] = std::stod(line.substr(line.find(',', first + 1) + 1));
    }
    return result;
  };
  const auto told = yaws(folder_content(out).at("fits.csv"));
  const auto right = yaws(archetype::read_file(made / "styles.csv"));
  REQUIRE(told.size() == 4);
  REQUIRE(right.size() == 4);
  double askew = 0;
  for (const auto& [name, yaw] : right) {
    CHECK(std::abs(std::remainder(told.at(name) - yaw, 360)) < 6);
    askew = std::max(askew, std::abs(std::remainder(yaw, 90)));
  }
  CHECK(askew > 20);
}

TEST_CASE("points are mapped from shape to shape and measured against landmarks") {
  const Fixture fixture;
  REQUIRE(fixture.fit().exit_code == 0);
  const std::string landmarks = (fixture.folder.path() / "landmarks").string();
  const auto curves = fixture.folder.path() / "curves.csv";
  Finished run = run_archetype(
      {"evaluate", fixture.project, "--landmarks", landmarks, "--curves", curves.string(), "--json"});
  CHECK(run.exit_code == 0);
  const auto report = nlohmann::json::parse(run.out).at("landmarks");
  CHECK(report.at("all").at("by_diameter").size() == report.at("thresholds").size());
  CHECK(report.at("shapes").size() == 4);
  CHECK(report.at("landmarks")[0].at("name") == "seat_front_left");
  CHECK(report.at("all").at("by_diameter")[50] > 0.5);
  CHECK(report.at("all").at("by_diagonal")[10] >= report.at("all").at("by_diameter")[10]);
  const std::string csv = archetype::read_file(curves);
  CHECK(std::ranges::count(csv, '\n') == 52);
  run = run_archetype({"evaluate", fixture.project, "--landmarks", landmarks, "--labels", fixture.labels});
  CHECK(run.exit_code == 0);
  CHECK(run.out.find("mean over 4 shapes") < run.out.find("By landmark"));

  // To itself, a point of the surface stays where it is.
  const std::string name = "chair_00001";
  const archetype::Vec3 vertex = archetype::read_shape(fixture.shapes + "/" + name + ".off").mesh.vertices[0];
  std::string text = "# two\n";
  for (const double coordinate : vertex) text += archetype::number_text(coordinate) + ' ';
  const auto points = fixture.folder.write("points.txt", text + "\n\n0 0 0\n");
  std::vector<std::string> arguments{"map", fixture.project, "--from",       name, "--to",
                                     name,  "--points",      points.string()};
  run = run_archetype(arguments);
  CHECK(run.exit_code == 0);
  CHECK(std::ranges::count(run.out, '\n') == 2);
  std::istringstream line(run.out);
  for (const double expected : vertex) {
    double found = 0;
    line >> found;
    CHECK(found == doctest::Approx(expected).epsilon(1e-9));
  }
  arguments.push_back("--json");
  CHECK(nlohmann::json::parse(run_archetype(arguments).out).at("points").size() == 2);

  fixture.folder.write("points.txt", "0 0\n");
  arguments.pop_back();
  run = run_archetype(arguments);
  CHECK(run.exit_code == 1);
  CHECK(run.err.find(points.string() + ", line 1") != std::string::npos);
  run = run_archetype({"map", fixture.project, "--from", "chair_9", "--to", "chair_00001", "--points", "x"});
  CHECK(run.exit_code == 1);
  run = run_archetype({"evaluate", fixture.project});
  CHECK(run.exit_code == 2);
  CHECK(run.err.find("--landmarks") != std::string::npos);
}

TEST_CASE("fit makes the project and imports first; without templates it takes the project's") {
  const Fixture fixture;
  CHECK(fixture.fit().out == "imported 4, unchanged 0, refused 0\nfitted 4, kept 0, refused 0\n");
  CHECK(run_archetype({"fit", fixture.project}).out == "fitted 0, kept 4, refused 0\n");
}

TEST_CASE("wrong usage is exit status 2 and one line") {
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {},
           {"nonsense"},
           {"import"},
           {"import", "p.archetype"},
           {"import", "p.archetype", "x", "--up", "w"},
           {"import", "p.archetype", "x", "--points", "1"},
           {"import", "p.archetype", "x", "--threads", "-1"},
           {"fit"},
           {"evaluate", "p.archetype"},
           {"export", "p.archetype"},
           {"export", "p.archetype", "--out", "x", "--only", "everything"},
           {"generate", "dragons", "--count", "1", "--out", "x"},
           {"generate", "chairs", "--count", "0", "--out", "x"},
           {"generate", "chairs", "--count", "1", "--out", "x", "--style", "nope"},
           {"help", "nonsense"},
       }) {
    const Finished run = run_archetype(arguments);
    CAPTURE(run.err);
    CHECK(run.exit_code == 2);
    CHECK(is_one_line(run.err));
    CHECK(run.out.empty());
  }
}

TEST_CASE("help and version are on standard output") {
  for (const char* argument : {"help", "--help"}) {
    const Finished run = run_archetype({argument});
    CHECK(run.exit_code == 0);
    for (const char* command : {"import", "fit", "evaluate", "export", "generate", "info"}) {
      CHECK(run.out.find(command) != std::string::npos);
    }
  }
  for (const char* option : {"--points", "--labels", "--only", "--style", "--threads"})
    CHECK(run_archetype({"help"}).out.find(option) != std::string::npos);
  CHECK(run_archetype({"help", "import"}).out.find("archetype import [OPTIONS] PROJECT PATH") !=
        std::string::npos);
  CHECK(run_archetype({"--version"}).out == "archetype " ARCHETYPE_VERSION "\n");
}

TEST_CASE("a failure is exit status 1 and one line that names the file and says what to do") {
  const Fixture fixture(1);
  const std::string none = (fixture.folder.path() / "none.archetype").string();
  const std::string text = fixture.folder.write("text.archetype", std::string(4096, 'x')).string();
  const std::string bad_template = fixture.folder.write("bad.json", "{ \"format\": 1 }").string();
  fixture.fit();
  for (const auto& [arguments, named] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"info", none}, none},
           {{"info", text}, text},
           {{"import", text, fixture.shapes}, text},
           {{"import", "/proc/p.archetype", fixture.shapes}, "/proc/p.archetype"},
           {{"fit", none, "--template", fixture.chair}, none},
           {{"fit", fixture.project, "--template", bad_template}, bad_template},
           {{"evaluate", fixture.project, "--labels", fixture.shapes}, fixture.shapes},
           {{"evaluate", fixture.project, "--labels", none}, none},
           {{"export", fixture.project, "--out", text}, text},
       }) {
    const Finished run = run_archetype(arguments);
    CAPTURE(run.err);
    CHECK(run.exit_code == 1);
    CHECK(is_one_line(run.err));
    CHECK(run.err.find(named) != std::string::npos);
  }
}

TEST_CASE("a project without templates says how to get one") {
  const Fixture fixture(1);
  require_run({"import", fixture.project, fixture.shapes, "--points", "100"});
  const Finished run = run_archetype({"fit", fixture.project});
  CHECK(run.exit_code == 1);
  CHECK(run.err.find("--template") != std::string::npos);
}

TEST_CASE("refused inputs are exit status 3, each with its reason; the rest is done") {
  const Fixture fixture;
  const std::string bad = fixture.folder.write("shapes/bad.off", "OFF\n3 1 0\n0 0 0\n").string();
  const Finished run = fixture.fit();
  CHECK(run.exit_code == 3);
  CHECK(run.out == "imported 4, unchanged 0, refused 1\nfitted 4, kept 0, refused 0\n");
  CHECK(run.err.find("refused: " + bad + ": ") != std::string::npos);
  CHECK(run_archetype({"info", fixture.project}).out.find(bad) != std::string::npos);
  CHECK(run_archetype({"import", fixture.project, fixture.shapes, "--points", "100", "--json"}).exit_code ==
        3);
}

TEST_CASE("up axes with a minus sign are values, not options") {
  const Fixture fixture(1);
  require_run({"import", fixture.project, fixture.shapes, "--points", "100", "--up", "-z"});
  const auto out = fixture.folder.path() / "g";
  require_run({"generate", "lamps", "--count", "2", "--out", out.string(), "--up", "-x", "--up", "z"});
  CHECK(folder_content(out / "shapes").size() == 2);
}

TEST_CASE("the batch program links nothing of OpenGL or of a window system") {
  FILE* pipe = popen("ldd " ARCHETYPE_BINARY_DIR "/bin/archetype", "r");
  REQUIRE(pipe != nullptr);
  std::string libraries;
  for (int c = fgetc(pipe); c != EOF; c = fgetc(pipe)) libraries.push_back(static_cast<char>(c));
  REQUIRE(pclose(pipe) == 0);
  CHECK(libraries.find("libsqlite3") != std::string::npos);
  for (const char* never :
       {"libGL", "libOpenGL", "libEGL", "libGLX", "libepoxy", "libglfw", "libX11", "libwayland"}) {
    CHECK(libraries.find(never) == std::string::npos);
  }
}

TEST_CASE("templates are suggested, ranked and stored, the best one to be fitted with") {
  const Fixture fixture(5);
  CHECK(run_archetype({"init", fixture.project}).exit_code == 1);
  require_run({"import", fixture.project, fixture.shapes, "--points", "150"});
  Finished run = run_archetype({"init", fixture.project, "--shapes", "3", "--candidates", "2", "--json"});
  CHECK(run.exit_code == 0);
  const auto report = nlohmann::json::parse(run.out);
  CHECK(report.at("segmented") == 3);
  CHECK(report.at("scored") == 5);
  REQUIRE(report.at("templates").size() == 2);
  CHECK(report.at("templates")[0].at("score") <= report.at("templates")[1].at("score"));
  {
    const archetype::Project project = archetype::Project::open(fixture.project);
    CHECK(project.templates(false).size() == 2);
    REQUIRE(project.templates().size() == 1);
    CHECK(project.templates()[0].part_template.name == report.at("templates")[0].at("name"));
  }
  require_run({"init", fixture.project, "--shapes", "3", "--candidates", "2"});
  CHECK(archetype::Project::open(fixture.project).templates(false).size() == 2);
  run = run_archetype({"fit", fixture.project});
  CHECK(run.out == "fitted 5, kept 0, refused 0\n");

  run = run_archetype({"init", fixture.project, "--shapes", "2", "--parts", "3:5"});
  CHECK(run.exit_code == 0);
  CHECK(run.out.find("mean energy") != std::string::npos);
  for (const char* wrong : {"5:3", "0:4", "3:", "a", "2:100"}) {
    CHECK(run_archetype({"init", fixture.project, "--parts", wrong}).exit_code == 2);
  }
}

TEST_CASE("suggested templates do not depend on the threads or the order of import") {
  const Fixture fixture(4);
  const auto suggested = [&](const std::string& project, const std::string& threads) {
    return run_archetype({"init", project, "--threads", threads, "--json"}).out;
  };
  require_run({"import", fixture.project, fixture.shapes, "--points", "100"});
  const std::string reordered = (fixture.folder.path() / "q.archetype").string();
  for (const char* index : {"2", "0", "3", "1"}) {
    require_run({"import", reordered, fixture.shapes + "/chair_0000" + index + ".off", "--points", "100"});
  }
  const std::string once = suggested(fixture.project, "1");
  CHECK(once == suggested(fixture.project, "2"));
  CHECK(once == suggested(fixture.project, "8"));
  CHECK(once == suggested(reordered, "2"));
}
