#include <doctest/doctest.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/base/error.h"
#include "core/generate/generate.h"
#include "core/io/read_shape.h"
#include "tests/support/scratch_folder.h"

using namespace archetype;
namespace fs = std::filesystem;

namespace {

std::string content(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  REQUIRE(file);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::map<std::string, std::string> all_files(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files[fs::relative(entry.path(), folder).string()] = content(entry.path());
  }
  return files;
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::stringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  if (!text.empty() && text.back() == separator && separator == ',') parts.emplace_back();
  return parts;
}

}  // namespace

TEST_CASE("a collection has a shape, labels and landmarks for every name, the same for any thread count") {
  const test::ScratchFolder folder;
  GenerateOptions options;
  options.count = 24;
  options.noise = 0.001;
  options.faults = {0.1, 0.1, 0.1, 0.1, 0.1};
  options.yaw = YawChoice::quarters;
  options.threads = 1;
  CHECK(write_collection("lamps", options, folder.path() / "one", {}).written == 24);
  options.threads = 4;
  CHECK(write_collection("lamps", options, folder.path() / "four", {}).written == 24);
  const auto files = all_files(folder.path() / "one");
  CHECK(files == all_files(folder.path() / "four"));
  CHECK(files.size() == 3 * 24 + 4);
  CHECK(files.at("labels/names.txt") == "0 shade\n1 tube\n2 base\n");
  const auto rows = split(files.at("styles.csv"), '\n');
  REQUIRE(rows.size() == 25);
  for (std::size_t i = 0; i < 24; ++i) {
    const GeneratedShape shape = generate_shape("lamps", options, i);
    const auto lines = split(files.at("labels/" + shape.name + ".seg"), '\n');
    REQUIRE(lines.size() == shape.labels.size());
    for (std::size_t f = 0; f < lines.size(); ++f) REQUIRE(lines[f] == std::to_string(shape.labels[f]));
    CHECK(files.at("shapes/" + shape.name + ".off")
              .rfind("OFF\n" + std::to_string(shape.mesh.vertices.size()) + ' ' +
                         std::to_string(shape.mesh.face_count()) + " 0\n",
                     0) == 0);
    CHECK(split(files.at("landmarks/" + shape.name + ".vts"), '\n').size() == shape.landmarks.size());
    CHECK(rows[i + 1].rfind(shape.name + ',' + shape.style + ',', 0) == 0);
  }
}

TEST_CASE("the parameters in styles.csv follow the distributions that generator.json states") {
  const test::ScratchFolder folder;
  for (const std::string& family : families()) {
    GenerateOptions options;
    options.count = 1500;
    write_collection(family, options, folder.path() / family, {});
    const auto stated = nlohmann::json::parse(content(folder.path() / family / "generator.json"));
    const auto rows = split(content(folder.path() / family / "styles.csv"), '\n');
    const auto columns = split(rows[0], ',');
    double weights = 0;
    for (const auto& style : stated["styles"]) weights += style["weight"].get<double>();
    for (const auto& style : stated["styles"]) {
      std::vector<std::vector<std::string>> own;
      for (std::size_t i = 1; i < rows.size(); ++i) {
        auto cells = split(rows[i], ',');
        REQUIRE(cells.size() == columns.size());
        if (cells[1] == style["name"]) own.push_back(std::move(cells));
      }
      const auto n = static_cast<double>(own.size());
      const double share = style["weight"].get<double>() / weights;
      CHECK(std::abs(n / 1500 - share) < 4.5 * std::sqrt(share * (1 - share) / 1500));
      for (const auto& parameter : style["parameters"]) {
        const std::string name = parameter["name"];
        CAPTURE(name);
        const auto column =
            static_cast<std::size_t>(std::find(columns.begin(), columns.end(), name) - columns.begin());
        REQUIRE(column < columns.size());
        const std::string kind = parameter["distribution"];
        double low = 0;
        double high = 1;
        double mean = 0;
        double deviation = 0;
        if (kind == "normal") {
          mean = parameter["mean"];
          deviation = parameter["stddev"];
          low = mean - 2.5 * deviation;
          high = mean + 2.5 * deviation;
        } else if (kind == "chance") {
          mean = parameter["probability"];
          deviation = std::sqrt(mean * (1 - mean));
        } else {
          low = parameter["low"];
          high = parameter["high"];
          mean = 0.5 * (low + high);
          const double values = high - low + 1;
          deviation =
              kind == "whole" ? std::sqrt((values * values - 1) / 12) : (high - low) / std::sqrt(12.0);
        }
        double sum = 0;
        for (const auto& cells : own) {
          const double value = std::strtod(cells[column].c_str(), nullptr);
          REQUIRE(value >= low - 1e-6);
          REQUIRE(value <= high + 1e-6);
          sum += value;
        }
        CHECK(std::abs(sum / n - mean) <= 4.5 * deviation / std::sqrt(n));
      }
    }
  }
}

TEST_CASE("a thousand chairs take seconds") {
  const test::ScratchFolder folder;
  GenerateOptions options;
  options.count = 1000;
  const auto start = std::chrono::steady_clock::now();
  CHECK(write_collection("chairs", options, folder.path(), {}).written == 1000);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  MESSAGE("1,000 chairs: ", seconds.count(), " s");
  CHECK(seconds.count() < 60);  // sanitizers and a busy machine included
}

TEST_CASE("a cancelled call goes on from what it left") {
  const test::ScratchFolder folder;
  GenerateOptions options;
  options.count = 200;
  options.threads = 1;
  std::stop_source source;
  JobControl control;
  control.stop = source.get_token();
  control.report = [&](std::size_t done, std::size_t total, std::string_view) {
    CHECK(total == 200);
    if (done == 5) source.request_stop();
  };
  const GenerateReport report = write_collection("tables", options, folder.path() / "tables", control);
  CHECK(report.cancelled);
  CHECK(report.written == 5);
  CHECK_FALSE(fs::exists(folder.path() / "tables" / "styles.csv"));
  const fs::path first =
      folder.path() / "tables" / "shapes" / (generate_shape("tables", options, 0).name + ".off");
  const auto written_at = fs::last_write_time(first);
  CHECK(write_collection("tables", options, folder.path() / "tables", {}).written == 200);
  CHECK(fs::exists(folder.path() / "tables" / "styles.csv"));
  CHECK(fs::last_write_time(first) == written_at);
}

TEST_CASE("other files are never mixed with a collection") {
  const test::ScratchFolder folder;
  GenerateOptions options;
  options.count = 2;
  write_collection("chairs", options, folder.path() / "chairs", {});
  options.seed = 2;
  CHECK_THROWS_AS(write_collection("chairs", options, folder.path() / "chairs", {}), FileError);
  CHECK_THROWS_AS(write_collection("lamps", options, folder.path() / "chairs", {}), FileError);
  std::ofstream(folder.path() / "file") << "x";
  CHECK_THROWS_AS(write_collection("lamps", options, folder.path(), {}), FileError);
  CHECK_THROWS_AS(write_collection("lamps", options, folder.path() / "file", {}), FileError);
  CHECK_THROWS_AS(write_collection("lamps", options, folder.path() / "file" / "below", {}), FileError);
  CHECK(content(folder.path() / "file") == "x");
}

TEST_CASE("a full disk is an error") {
  if (!fs::exists("/dev/full")) return;
  const test::ScratchFolder folder;
  GenerateOptions options;
  options.count = 1;
  write_collection("chairs", options, folder.path(), {});
  const fs::path shape = folder.path() / "shapes" / (generate_shape("chairs", options, 0).name + ".off");
  fs::remove(shape);
  fs::create_symlink("/dev/full", shape.string() + ".part");  // where it is written first
  CHECK_THROWS_AS(write_collection("chairs", options, folder.path(), {}), FileError);
}

TEST_CASE("what was written reads back: every face, label and landmark, also of faulty shapes") {
  for (const ShapeEnding ending : {ShapeEnding::off, ShapeEnding::obj}) {
    const test::ScratchFolder folder;
    GenerateOptions options;
    options.count = 3;
    options.ending = ending;
    options.faults = {0.1, 0.1, 0.1, 0.1, 0.1};
    options.offset = 1;
    write_collection("planes", options, folder.path(), {});
    for (std::size_t i = 0; i < options.count; ++i) {
      const GeneratedShape shape = generate_shape("planes", options, i);
      const char* const suffix = ending == ShapeEnding::off ? ".off" : ".obj";
      const PolygonMesh mesh = read_shape(folder.path() / "shapes" / (shape.name + suffix)).mesh;
      REQUIRE(mesh.face_corners == shape.mesh.face_corners);
      REQUIRE(mesh.face_begins == shape.mesh.face_begins);
      const double size = bounds(shape.mesh).high.norm() + bounds(shape.mesh).low.norm();
      for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        REQUIRE((mesh.vertices[v] - shape.mesh.vertices[v]).norm() < 1e-7 * size);
      }
      CHECK(read_labels(folder.path() / "labels" / (shape.name + ".seg"), mesh.face_count()) == shape.labels);
      const auto landmarks = read_landmarks(folder.path() / "landmarks" / (shape.name + ".vts"));
      REQUIRE(landmarks.size() == shape.landmarks.size());
      for (std::size_t k = 0; k < landmarks.size(); ++k)
        CHECK(landmarks[k].present == shape.landmarks[k].present);
    }
  }
}

TEST_CASE("OBJ files name the part of every face") {
  const test::ScratchFolder folder;
  GenerateOptions options;
  options.count = 1;
  options.ending = ShapeEnding::obj;
  write_collection("chairs", options, folder.path(), {});
  const GeneratedShape shape = generate_shape("chairs", options, 0);
  const FamilyNames names = family_names("chairs");
  std::string group;
  std::size_t face = 0;
  for (const std::string& line : split(content(folder.path() / "shapes" / (shape.name + ".obj")), '\n')) {
    if (line.rfind("g ", 0) == 0) group = line.substr(2);
    if (line.rfind("f ", 0) == 0) {
      CHECK(group == names.labels[static_cast<std::size_t>(shape.labels[face])]);
      ++face;
    }
  }
  CHECK(face == shape.mesh.face_count());
}
