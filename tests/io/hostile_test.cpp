// Every reader against malformed and hostile files: each is refused with a message that names the file and
// says what is wrong, before much memory is taken.
#include <doctest/doctest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <set>

#include "core/base/error.h"
#include "core/io/labels.h"
#include "core/io/read_shape.h"
#include "core/io/template_file.h"
#include "tests/io/allocation_meter.h"
#include "tests/io/hostile_corpus.h"
#include "tests/support/scratch_folder.h"

using namespace archetype;
using namespace archetype::test;

namespace {

void read_any(const std::filesystem::path& path) {
  if (has_shape_ending(path)) {
    read_shape(path);
  } else if (path.extension() == ".json") {
    read_template(path);
  } else if (path.extension() == ".vts") {
    read_landmarks(path);
  } else {
    read_labels(path, 3);
  }
}

void check_refused(const std::vector<HostileFile>& files) {
  const ScratchFolder folder;
  for (const HostileFile& file : files) {
    CAPTURE(file.name);
    const auto path = folder.write(file.name, file.bytes);
    // A hash table of pointers in the parsed document, and some room for small files.
    const std::size_t limit = (1 << 20) + 64 * file.bytes.size();
    std::string message = "read without complaint";
    reset_peak_memory();
    try {
      read_any(path);
    } catch (const InputError& error) {
      message = error.what();
    }
    const std::size_t peak = peak_memory();
    CHECK(peak > 0);  // the meter measures
    CHECK(message.starts_with(path.string()));
    CHECK(message.find('\n') == message.npos);
    CHECK_MESSAGE(message.find(file.expected) != message.npos, message, " should say ", file.expected);
    if (file.name != "slabs.binvox" && file.name != "instances.gltf") CHECK(peak < limit);
    CHECK(peak < std::size_t{1} << 30);  // those two have limits of their own
  }
}

}  // namespace

TEST_CASE("hostile OBJ, OFF, STL and AC3D files are refused") {
  check_refused(hostile_meshes());
}
TEST_CASE("hostile PLY files are refused") {
  check_refused(hostile_ply());
}
TEST_CASE("hostile glTF files are refused") {
  check_refused(hostile_gltf());
}
TEST_CASE("hostile point sets and voxel grids are refused") {
  check_refused(hostile_points());
}
TEST_CASE("hostile templates, labels and landmarks are refused") {
  check_refused(hostile_side_files());
}

TEST_CASE("the corpus is as large as promised, and no file stands in it twice") {
  std::set<std::string> names;
  std::size_t count = 0;
  for (const auto& files :
       {hostile_meshes(), hostile_ply(), hostile_gltf(), hostile_points(), hostile_side_files()}) {
    for (const HostileFile& file : files) names.insert(file.name);
    count += files.size();
  }
  CHECK(count >= 60);
  CHECK(names.size() == count);
}

TEST_CASE("what is no file at all is refused without waiting") {
  const ScratchFolder folder;
  for (const char* ending :
       {".obj", ".off", ".ply", ".stl", ".gltf", ".glb", ".xyz", ".pts", ".ac", ".binvox"}) {
    CAPTURE(ending);
    const auto path = folder.path() / (std::string("a") + ending);
    CHECK(has_shape_ending(path));
    CHECK_THROWS_WITH_AS(read_shape(path), doctest::Contains("cannot be opened (No such file or directory)"),
                         FileError);
    std::filesystem::create_directory(path);
    CHECK_THROWS_WITH_AS(read_shape(path), doctest::Contains("is a folder, not a file"), FileError);
    std::filesystem::remove(path);
    REQUIRE(::mkfifo(path.c_str(), 0600) == 0);
    CHECK_THROWS_WITH_AS(read_shape(path), doctest::Contains("is a pipe or device, not a file"), FileError);
    std::filesystem::remove(path);
    std::filesystem::create_symlink(path, path);
    CHECK_THROWS_AS(read_shape(path), FileError);
  }
  CHECK_FALSE(has_shape_ending("a.txt"));
  CHECK_FALSE(has_shape_ending("obj"));
  CHECK_THROWS_WITH_AS(read_shape(folder.write("a.txt", "v 0 0 0")),
                       doctest::Contains("expected one of .obj .off"), InputError);
}

TEST_CASE("a file beyond the size limit is refused before it is read") {
  const ScratchFolder folder;
  const auto path = folder.write("a.obj", "v 0 0 0\n");
  std::filesystem::resize_file(path, (std::uintmax_t{2} << 30) + 1);  // sparse: takes no room on the disk
  reset_peak_memory();
  CHECK_THROWS_WITH_AS(read_shape(path), doctest::Contains("at most 2147483648 are read"), FileError);
  CHECK(peak_memory() < 1 << 20);
}

TEST_CASE("an element of a PLY file without properties takes neither time nor memory, whatever its count") {
  const ScratchFolder folder;
  const auto path = folder.write(
      "a.ply",
      "ply\nformat binary_little_endian 1.0\nelement nothing 9223372036854775807\nelement vertex 1\n"
      "property uchar x\nproperty uchar y\nproperty uchar z\nend_header\nabc");
  CHECK(read_shape(path).mesh.vertices.size() == 1);
}
