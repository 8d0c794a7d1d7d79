// What sloppy OBJ and OFF files read as. Files that must be refused stand in hostile_test.cpp.
#include <doctest/doctest.h>

#include "tests/io/shape_reading.h"

using namespace archetype;
using namespace archetype::test;

TEST_CASE("OBJ keeps every polygon in file order, whatever its topology") {
  const ShapeFile shape = read_as("a.obj",
                                  "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\n"
                                  "f 1 2 3 4\n"                  // a quad
                                  "f 1 2 3\nf 1 2 3\n"           // the same twice
                                  "f 1 2 2\n"                    // a corner repeated
                                  "f 1 2\n"                      // too few corners
                                  "f\n"                          // none
                                  "f 1 2 5\nf 2 1 5\nf 1 2 4\n"  // three and more faces at one edge
                                  "f 3 2 1\n");
  CHECK(faces(shape.mesh) == Faces{{0, 1, 2, 3},
                                   {0, 1, 2},
                                   {0, 1, 2},
                                   {0, 1, 1},
                                   {0, 1},
                                   {},
                                   {0, 1, 4},
                                   {1, 0, 4},
                                   {0, 1, 3},
                                   {2, 1, 0}});
  CHECK(shape.mesh.vertices.size() == 5);
  REQUIRE(shape.warnings.size() == 1);
  CHECK(shape.warnings[0].starts_with("3 of 10 faces"));
}

TEST_CASE("OBJ corners may be slashed, count backwards, or come before their vertices") {
  const ShapeFile shape = read_as("a.OBJ",
                                  "f 1/1/1 2//2 3/3\r\nv 0 0 0\r\nv 1 0 0 1 0.5 0.5 0.5\r\nv 1 1 0\r\n"
                                  "f -1 -2/7/7 -3//-9\r\nv 0 1 0\r\nf -1 -2 -3 -4");
  CHECK(faces(shape.mesh) == Faces{{0, 1, 2}, {2, 1, 0}, {3, 2, 1, 0}});
}

TEST_CASE("OBJ lines may be continued, blank, commented, tabbed, and end in LF, CR LF or CR") {
  const Faces expected{{0, 1, 2}};
  CHECK(faces(read_as("a.obj", "# x\\\nv 0 0 0 # end\n\n  v\t1 0 \\\n 0\nv 1 1 0\nf 1 2\\\n 3\n").mesh) ==
        expected);
  CHECK(faces(read_as("a.obj", "v 0 0 0\rv 1 0 0\r\rv 1 1 0\rf 1 2 3").mesh) == expected);
  CHECK(faces(read_as("a.obj", "\xEF\xBB\xBFv 0 0 0\r\nv 1 0 0\\\r\n\r\nv 1 1 0\r\nf 1 2 3\r\n").mesh) ==
        expected);
}

TEST_CASE("OBJ passes over all that is no polygon, and opens no other file") {
  const ShapeFile shape =
      read_as("a.obj",
              "mtllib /etc/passwd\ncall /etc/passwd\no one\ng a b\ns off\nusemtl x\nv 0 0 0\nv 1 0 0\n"
              "vt 0 0\nvn 0 0 1\nvp 1\nl 1 2\np 1\nv 1 1 0\no two\nf 1 2 3\ncurv 0 1 1 2\n");
  CHECK(faces(shape.mesh) == Faces{{0, 1, 2}});
  CHECK(shape.warnings.empty());
}

TEST_CASE("numbers are read to the bit, in every way of writing them") {
  const ShapeFile shape =
      read_as("a.obj", "v +1.5 -2.e1 .25\nv 1e-400 0.1 1E+2\nv 1.2345678901234567e29 4.9e-324 -0\n");
  CHECK(shape.mesh.vertices[0] == Vec3(1.5, -20, 0.25));
  CHECK(shape.mesh.vertices[1] == Vec3(0, 0.1, 100));
  CHECK(shape.mesh.vertices[2] == Vec3(1.2345678901234567e29, 4.9e-324, 0));
  CHECK(shape.mesh.is_point_set());
}

TEST_CASE("the hash is of the file's bytes") {
  const std::string text = "v 0 0 0\n";
  CHECK(read_as("a.obj", text).hash == hash_content(std::as_bytes(std::span(text))));
  CHECK(read_as("a.obj", text).hash != read_as("a.obj", text + text).hash);
}

TEST_CASE("OFF headers of all kinds read the same") {
  const std::string body = "0 0 0\n1 0 0\n1 1 0\n3 0 1 2\n3 2 1 0\n";
  const Faces expected{{0, 1, 2}, {2, 1, 0}};
  for (const char* header :
       {"OFF\n3 2 0\n", "OFF3 2 0\n", "OFF 3 2 0\n", "OFF # c\n# c\n\n3 2 0 # c\n", "3 2 0\n", "3 2\n",
        "off\n3 2 0\n", "OFF\r\n3 2 0\r\n", "\xEF\xBB\xBFOFF\n3 2 0\n"}) {
    CAPTURE(header);
    CHECK(faces(read_as("a.off", header + body).mesh) == expected);
  }
  CHECK(read_as("a.off", "3 2 0\n" + body).warnings.size() == 1);
  CHECK(read_as("a.off", "OFF\n3 2 0\n" + body).warnings.empty());
}

TEST_CASE("OFF colours, normals and texture coordinates are passed over") {
  CHECK(faces(read_as("a.off",
                      "COFF\n3 1 0\n0 0 0 255 0 0 255\n1 0 0 1 1 1 1\n1 1 0 1 1 1 1\n3 0 1 2 0.5 0.5 0.5\n")
                  .mesh) == Faces{{0, 1, 2}});
  CHECK(faces(read_as("a.off", "STCN4OFF 3 1 0\n0 0 0 1 9 9 9\n1 0 0 2\n1 1 0 1\n3 0 1 2").mesh) ==
        Faces{{0, 1, 2}});
  CHECK(read_as("a.off", "4OFF 1 0 0\n1 2 3 2\n").mesh.vertices[0] == Vec3(0.5, 1, 1.5));
}

TEST_CASE("OFF keeps degenerate faces and polygons, and NOFF without faces is a point set with normals") {
  const ShapeFile shape = read_as(
      "a.off", "OFF\n4 5 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n0\n1 2\n3 1 1 2\n5 0 1 2 3 0\nx\n");
  CHECK(faces(shape.mesh) == Faces{{0, 1, 2, 3}, {}, {2}, {1, 1, 2}, {0, 1, 2, 3, 0}});
  CHECK(shape.warnings.size() == 2);
  const ShapeFile points = read_as("a.off", "NOFF\n2 0 0\n0 0 0 0 0 2\n1 1 1 1 0 0\n");
  CHECK(points.mesh.is_point_set());
  CHECK(points.mesh.point_normals == std::vector<Vec3>{Vec3(0, 0, 1), Vec3(1, 0, 0)});
}
