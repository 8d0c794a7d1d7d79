#include <doctest/doctest.h>

#include "tests/io/shape_reading.h"

using namespace archetype;
using namespace archetype::test;

TEST_CASE("XYZ and PTS: the count line is optional, further columns are passed over") {
  const std::vector<Vec3> expected{Vec3(1, 2, 3), Vec3(4, 5, 6)};
  for (const char* text :
       {"1 2 3\n4 5 6\n", "2\n1 2 3\n4 5 6", "1 2 3 -1 255 0 0\r\n4 5 6 -2 255 0 0\r\n",
        "# c\n1 2 3 7\n\n4 5 6 8 # c\n", "1\n1 2 3\n1\n4 5 6\n", "1 2 3 255 0 0\n4 5 6 0 0 255\n"}) {
    CAPTURE(text);
    for (const char* name : {"a.xyz", "a.PTS"}) {
      const PolygonMesh mesh = read_as(name, text).mesh;
      CHECK(mesh.vertices == expected);
      CHECK(mesh.is_point_set());
      CHECK(mesh.point_normals.empty());
    }
  }
}

TEST_CASE("XYZ: columns four to six are normals if they look it") {
  const PolygonMesh mesh = read_as("a.xyz", "1 2 3 0 0 1.001\n4 5 6 0 0 0\n").mesh;
  CHECK(mesh.point_normals == std::vector<Vec3>{Vec3(0, 0, 1), Vec3::Zero()});
  CHECK(read_as("a.xyz", "1 2 3 0 0 0\n4 5 6 0 0 0\n").mesh.point_normals.empty());  // black
  CHECK(read_as("a.xyz", "1 2 3 0 0 1\n4 5 6 0.5 0.5 0.5\n").mesh.point_normals.empty());
  CHECK(read_as("a.xyz", "1 2 3 0 0 1 7\n4 5 6 0 0 1 7\n").mesh.point_normals.empty());
}
