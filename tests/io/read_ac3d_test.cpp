// AC3D object trees.
#include <doctest/doctest.h>

#include "core/base/error.h"
#include "tests/io/shape_reading.h"

using namespace archetype;
using namespace archetype::test;

namespace {

// A triangle and a line in one object.
const std::string triangle =
    "numvert 3\n0 0 0\n1 0 0\n0 1 0\nnumsurf 2\nSURF 0x20\nmat 0\nrefs 3\n0 0 0\n1 0 0\n2 0 0\n"
    "SURF 0X2\nmat 0\nrefs 2\n0 0 0\n1 0 0\n";

}  // namespace

TEST_CASE("AC3D: transforms accumulate down the tree, polygons of all objects come in file order") {
  const ShapeFile shape =
      read_as("a.ac",
              "AC3Db\r\nMATERIAL \"m\" rgb 1 1 1\r\nOBJECT world\nkids 2\n"
              "OBJECT group\nname \"OBJECT poly\nloc 10 0 0\nrot 0 1 0 -1 0 0 0 0 1\nkids 1\n"
              "OBJECT poly\ndata 14\nOBJECT\nkids 9\nloc 0 0 5\n" +
                  triangle +
                  "kids 0\n"
                  "OBJECT poly\nnumvert 2\n7 7 7\n8 8 8\nnumsurf 3\nSURF 0\nrefs 2\n1\n0\nSURF 0x10\nmat "
                  "3\nrefs 0\nSURF 0x30\nrefs 4\n0\n1\n1\n0\n"
                  "kids 0");
  CHECK(faces(shape.mesh) == Faces{{0, 1, 2}, {4, 3}, {}, {3, 4, 4, 3}});
  // Row vectors: x maps to y, y to -x.
  CHECK(shape.mesh.vertices ==
        std::vector<Vec3>{Vec3(10, 0, 5), Vec3(10, 1, 5), Vec3(9, 0, 5), Vec3(7, 7, 7), Vec3(8, 8, 8)});
  REQUIRE(shape.warnings.size() == 2);
  CHECK(shape.warnings[0] == "surfaces that are lines and no faces: 1");
}

TEST_CASE("AC3D: fewer kids than promised is said, an object that is cut off is refused") {
  const std::string start = "AC3Db\nOBJECT world\nkids 2\nOBJECT poly\n" + triangle;
  const ShapeFile shape = read_as("a.ac", start + "kids 0\n");
  CHECK(shape.mesh.face_count() == 1);
  CHECK(shape.warnings.front() == "fewer objects than promised; the file may be cut off");
  CHECK_THROWS_WITH_AS(read_as("a.ac", start), doctest::Contains("the file ends within an object"),
                       InputError);
}
