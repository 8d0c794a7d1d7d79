// Files are replaced as a whole or not at all.
#include <doctest/doctest.h>
#include <sys/stat.h>

#include "core/base/error.h"
#include "core/io/file.h"
#include "tests/support/disk_limit.h"
#include "tests/support/scratch_folder.h"

using namespace archetype;
using namespace archetype::test;

namespace {

std::size_t files_in(const ScratchFolder& folder) {
  return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder.path()), {}));
}

mode_t mode_of(const std::filesystem::path& path) {
  struct stat info {};
  REQUIRE(::stat(path.c_str(), &info) == 0);
  return info.st_mode & 0777U;
}

}  // namespace

TEST_CASE("replacing a file writes it as a whole and leaves nothing else behind") {
  const ScratchFolder folder;
  const auto path = folder.path() / "a.txt";
  const std::string content("a\0b\r\n", 5);
  replace_file(path, content);
  CHECK(read_file(path) == content);
  replace_file(path, "");
  CHECK(read_file(path).empty());
  CHECK(files_in(folder) == 1);
}

TEST_CASE("a file that cannot be written to its end stays as it was") {
  const ScratchFolder folder;
  const auto path = folder.write("a.txt", "the old content");
  {
    const DiskLimit limit(1000);
    CHECK_THROWS_WITH_AS(replace_file(path, std::string(5000, 'x')),
                         doctest::Contains("cannot be written (write: "), FileError);
  }
  CHECK(read_file(path) == "the old content");
  CHECK(files_in(folder) == 1);
}

TEST_CASE("a replaced file keeps its permissions, a new one has what the umask gives") {
  const ScratchFolder folder;
  const auto path = folder.write("a.txt", "x");
  REQUIRE(::chmod(path.c_str(), 0640) == 0);
  const mode_t umask_before = ::umask(077);
  replace_file(path, "y");
  replace_file(folder.path() / "b.txt", "y");
  ::umask(umask_before);
  CHECK(mode_of(path) == 0640);
  CHECK(mode_of(folder.path() / "b.txt") == 0600);
}
