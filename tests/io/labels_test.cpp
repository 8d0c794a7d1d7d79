#include <doctest/doctest.h>

#include "core/base/error.h"
#include "core/io/labels.h"
#include "tests/support/scratch_folder.h"

using namespace archetype;
using namespace archetype::test;

TEST_CASE("labels: one integer a line") {
  const ScratchFolder folder;
  CHECK(read_labels(folder.write("a.seg", "0\r\n2\n\n -1 \n7"), 4) == std::vector<int>{0, 2, -1, 7});
  CHECK_THROWS_WITH_AS(read_labels(folder.path() / "a.seg", 5),
                       doctest::Contains("expected one label for each of the 5"), InputError);
  CHECK_THROWS_AS(read_labels(folder.path() / "a.seg", 3), InputError);
  CHECK_THROWS_AS(read_labels(folder.path() / "missing.seg", 3), FileError);
}

TEST_CASE("labels: names and 1-based faces, numbered in order of appearance") {
  const ScratchFolder folder;
  const auto path = folder.write("chair_labels.txt", "leg\n2 3\nback rest\n\nseat\n1 5\nleg\n6\n");
  CHECK(read_labels(path, 7) == std::vector<int>{2, 0, 0, -1, 2, 0, -1});
  CHECK_THROWS_WITH_AS(read_labels(path, 5),
                       doctest::Contains("line 8: expected face numbers from 1 to 5, found 6"), InputError);
}

TEST_CASE("names.txt names numbers from 0 on, or is another file") {
  const ScratchFolder folder;
  CHECK(read_numbered_names(folder.path()).empty());
  folder.write("names.txt", "0 seat\r\n1 back rest\n2 leg");
  CHECK(read_numbered_names(folder.path()) == std::vector<std::string>{"seat", "back rest", "leg"});
  for (const char* other : {"", "seat\nback\n", "0 seat\n2 leg\n", "1 seat\n", "0\n"}) {
    CAPTURE(other);
    folder.write("names.txt", other);
    CHECK(read_numbered_names(folder.path()).empty());
  }
}

TEST_CASE("labels are found by the shape's name, .seg first, only inside the folder") {
  const ScratchFolder folder;
  folder.write("in/a.seg", "");
  folder.write("in/a_labels.txt", "");
  folder.write("in/b_labels.txt", "");
  folder.write("c.seg", "");
  const auto in = folder.path() / "in";
  CHECK(find_labels(in, "a") == in / "a.seg");
  CHECK(find_labels(in, "b") == in / "b_labels.txt");
  CHECK_FALSE(find_labels(in, "c"));
  CHECK_FALSE(find_labels(in, "../c"));
}

TEST_CASE("written labels are read again, and replace a file as a whole") {
  const ScratchFolder folder;
  const auto path = folder.write("a.seg", "old");
  const std::vector<int> labels{3, -1, 0, 2147483647};
  write_labels(path, labels);
  CHECK(read_labels(path, 4) == labels);
  CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
  CHECK_THROWS_AS(write_labels(folder.path() / "no" / "a.seg", labels), FileError);
}

TEST_CASE("landmarks: three coordinates, or -1 for one that the shape lacks") {
  const ScratchFolder folder;
  const auto landmarks = read_landmarks(folder.write("a.vts", "1 2.5 -3\n-1\n\n-1 -1 -1"));
  REQUIRE(landmarks.size() == 3);
  CHECK(landmarks[0].present);
  CHECK(landmarks[0].position == std::array<double, 3>{1, 2.5, -3});
  CHECK_FALSE(landmarks[1].present);
  CHECK(landmarks[2].present);
}
