// A small fuzz test, the same on every run: valid files with bytes changed, cut, doubled or exchanged either
// read or are refused, within bounds on memory and time.
#include <doctest/doctest.h>

#include <ctime>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/io/labels.h"
#include "core/io/read_shape.h"
#include "core/io/template_file.h"
#include "tests/io/allocation_meter.h"
#include "tests/io/sample_files.h"
#include "tests/support/scratch_folder.h"

using namespace archetype;
using namespace archetype::test;

namespace {

constexpr int rounds_per_file = 300;
// Values that sit at the edges of number types, as text and as bytes.
const std::vector<std::string> poison{"-1",
                                      "0",
                                      "4294967295",
                                      "1e308",
                                      "nan",
                                      "-",
                                      " ",
                                      "\n",
                                      "\"",
                                      "[",
                                      "{",
                                      std::string(1, '\0'),
                                      "\xFF\xFF\xFF\xFF",
                                      "\xFF\xFF\xFF\x7F",
                                      "18446744073709551615"};

void mutate(std::string& bytes, RandomStream& random) {
  const auto place = [&] { return bytes.empty() ? 0 : random.below(bytes.size()); };
  const std::size_t at = place();
  switch (random.below(6)) {
    case 0:
      if (!bytes.empty()) bytes[at] = static_cast<char>(bytes[at] ^ (1 << random.below(8)));
      break;
    case 1:
      if (!bytes.empty()) bytes[at] = static_cast<char>(random.below(256));
      break;
    case 2:
      bytes.resize(at);
      break;
    case 3:
      bytes.insert(at, bytes.substr(place(), random.below(40)));
      break;
    case 4:
      bytes.erase(at, random.below(20));
      break;
    default: {
      const std::string& value = poison[random.below(poison.size())];
      bytes.replace(at, random.below(value.size() + 1), value);
    }
  }
}

// Whether the result keeps what a PolygonMesh promises to all who use it.
void check_consistent(const PolygonMesh& mesh) {
  REQUIRE(mesh.face_begins.front() == 0);
  REQUIRE(mesh.face_begins.back() == mesh.face_corners.size());
  for (std::size_t f = 0; f < mesh.face_count(); ++f) REQUIRE(mesh.face_begins[f] <= mesh.face_begins[f + 1]);
  for (const std::uint32_t corner : mesh.face_corners) REQUIRE(corner < mesh.vertices.size());
  for (const Vec3& vertex : mesh.vertices) REQUIRE(vertex.allFinite());
  REQUIRE_FALSE(mesh.vertices.empty());
  if (!mesh.point_normals.empty()) REQUIRE(mesh.point_normals.size() == mesh.vertices.size());
  for (const Vec3& normal : mesh.point_normals)
    REQUIRE((normal.isZero() || std::abs(normal.norm() - 1) < 1e-9));
}

void read_any(const std::filesystem::path& path) {
  if (has_shape_ending(path)) {
    check_consistent(read_shape(path).mesh);
  } else if (path.extension() == ".json") {
    const PartTemplate part_template = read_template(path);
    const PartTemplate again = parse_template(format_template(part_template), path);
    REQUIRE(again == part_template);
  } else if (path.extension() == ".vts") {
    read_landmarks(path);
  } else {
    const std::vector<int> labels = read_labels(path, 3);
    REQUIRE(labels.size() == 3);
  }
}

// Returns how many of the mutated files could be read.
int fuzz(const SampleFile& sample) {
  const ScratchFolder folder;
  RandomStream random(hash_content(std::as_bytes(std::span(sample.name))).words[0]);
  int read = 0;
  for (int round = 0; round < rounds_per_file; ++round) {
    std::string bytes = sample.bytes;
    for (std::uint64_t changes = 1 + random.below(3); changes > 0; --changes) mutate(bytes, random);
    const auto path = folder.write(sample.name, bytes);
    CAPTURE(sample.name);
    CAPTURE(round);
    reset_peak_memory();
    const std::clock_t begin = std::clock();
    try {
      read_any(path);
      ++read;
    } catch (const Error& error) {
      REQUIRE(std::string(error.what()).find(sample.name) != std::string::npos);
    }
    REQUIRE(peak_memory() < (4 << 20) + 64 * bytes.size());
    REQUIRE(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC < 1);  // of processor time
  }
  return read;
}

}  // namespace

TEST_CASE("the samples themselves are read") {
  const ScratchFolder folder;
  for (const auto& samples : {sample_shapes(), sample_side_files()}) {
    for (const SampleFile& sample : samples) {
      CAPTURE(sample.name);
      CHECK_NOTHROW(read_any(folder.write(sample.name, sample.bytes)));
    }
  }
}

TEST_CASE("changed files either read or are refused") {
  for (const auto& samples : {sample_shapes(), sample_side_files()}) {
    for (const SampleFile& sample : samples) {
      const int read = fuzz(sample);
      CAPTURE(sample.name);
      // Both must happen, or the changes test nothing.
      CHECK(read > 0);
      CHECK(read < rounds_per_file);
    }
  }
}

TEST_CASE("every shape cut anywhere either reads with a warning or less, or is refused") {
  const ScratchFolder folder;
  for (const SampleFile& sample : sample_shapes()) {
    CAPTURE(sample.name);
    for (std::size_t length = 0; length < sample.bytes.size(); ++length) {
      CAPTURE(length);
      const auto path = folder.write(sample.name, sample.bytes.substr(0, length));
      try {
        check_consistent(read_shape(path).mesh);
      } catch (const InputError&) {
      }
    }
  }
}
