// PLY in its three encodings, written by a small encoder here.
#include <doctest/doctest.h>

#include "tests/io/ply_encoder.h"
#include "tests/io/shape_reading.h"

using namespace archetype;
using namespace archetype::test;

TEST_CASE(
    "PLY reads the same in ASCII and both byte orders, in any order of properties, with extras passed over") {
  for (const PlyFlavour flavour : all_ply_flavours) {
    CAPTURE(ply_name(flavour));
    PlyEncoder ply(flavour);
    ply.header(
        "comment made by hand\nobj_info x\nelement camera 1\nproperty list uchar short trace\nproperty "
        "double t\n"
        "element vertex 4\nproperty uchar red\nproperty double z\nproperty float x\nproperty list int float "
        "weights\n"
        "property int y\nelement face 3\nproperty uchar flags\nproperty list ushort uint vertex_index\n"
        "element edge 1\nproperty int a\n");
    ply.value<std::uint8_t>(2).value<std::int16_t>(-7).value<std::int16_t>(8).value<double>(0.5).end_record();
    for (int i = 0; i < 4; ++i) {
      ply.value<std::uint8_t>(200).value<double>(i + 0.25).value<float>(0.5F * static_cast<float>(i));
      ply.value<std::int32_t>(i % 2);
      if (i % 2 == 1) ply.value<float>(3);
      ply.value<std::int32_t>(-i).end_record();
    }
    const auto face = [&](std::initializer_list<std::uint32_t> corners) {
      ply.value<std::uint8_t>(1).value<std::uint16_t>(static_cast<std::uint16_t>(corners.size()));
      for (const std::uint32_t corner : corners) ply.value<std::uint32_t>(corner);
      ply.end_record();
    };
    face({0, 1, 2, 3});
    face({});
    face({2, 2, 1});
    ply.value<std::int32_t>(1).end_record();

    const ShapeFile shape = read_as("a.ply", ply.bytes());
    CHECK(faces(shape.mesh) == Faces{{0, 1, 2, 3}, {}, {2, 2, 1}});
    REQUIRE(shape.mesh.vertices.size() == 4);
    for (int i = 0; i < 4; ++i)
      CHECK(shape.mesh.vertices[static_cast<std::size_t>(i)] == Vec3(0.5 * i, -i, i + 0.25));
  }
}

TEST_CASE("PLY faces may come before the vertices, and strips become triangles") {
  for (const PlyFlavour flavour : all_ply_flavours) {
    CAPTURE(ply_name(flavour));
    PlyEncoder ply(flavour);
    ply.header(
        "element face 1\nproperty list uchar int vertex_indices\nelement tristrips 1\n"
        "property list int int vertex_indices\nelement vertex 5\nproperty float x\nproperty float "
        "y\nproperty float z\n");
    ply.value<std::uint8_t>(3)
        .value<std::int32_t>(0)
        .value<std::int32_t>(1)
        .value<std::int32_t>(2)
        .end_record();
    ply.value<std::int32_t>(8);
    for (const std::int32_t corner : {0, 1, 2, 3, -1, 2, 3, 4}) ply.value<std::int32_t>(corner);
    ply.end_record();
    for (int i = 0; i < 5; ++i) ply.value<float>(1).value<float>(2).value<float>(3).end_record();
    CHECK(faces(read_as("a.ply", ply.bytes()).mesh) == Faces{{0, 1, 2}, {0, 1, 2}, {2, 1, 3}, {2, 3, 4}});
  }
}

TEST_CASE("PLY without faces is a point set, with unit normals if it has any") {
  for (const PlyFlavour flavour : all_ply_flavours) {
    PlyEncoder ply(flavour);
    ply.header(
        "element vertex 2\nproperty float x\nproperty float y\nproperty float z\nproperty float nx\nproperty "
        "float ny\n"
        "property float nz\nelement face 0\nproperty list uchar int vertex_indices\n");
    for (const float z : {0.F, 2.F}) {
      for (const float v : {1.F, 2.F, 3.F, 0.F, 0.F, z}) ply.value<float>(v);
      ply.end_record();
    }
    const PolygonMesh mesh = read_as("a.ply", ply.bytes()).mesh;
    CHECK(mesh.is_point_set());
    CHECK(mesh.element_count() == 2);
    CHECK(mesh.point_normals == std::vector<Vec3>{Vec3::Zero(), Vec3(0, 0, 1)});
  }
}

TEST_CASE("PLY headers end in LF, CR LF or CR") {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    std::string text;
    for (const char* line : {"ply", "format ascii 1.0", "element vertex 1", "property float x",
                             "property float y", "property float z", "end_header", "1 2 3"}) {
      text += line + end;
    }
    CHECK(read_as("a.ply", text).mesh.vertices == std::vector<Vec3>{Vec3(1, 2, 3)});
  }
}

TEST_CASE("a binary PLY body may begin with the bytes of a line end") {
  std::string text =
      "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty uchar x\nproperty uchar y\n"
      "property uchar z\nend_header\n";
  text += "\n\r\n";
  CHECK(read_as("a.ply", text).mesh.vertices == std::vector<Vec3>{Vec3(10, 13, 10)});
}

TEST_CASE("PLY values that the header does not describe are said") {
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float "
      "z\nend_header\n";
  CHECK(read_as("a.ply", header + "1 2 3\n4 5 6\n\n").warnings.empty());
  CHECK(read_as("a.ply", header + "1 2 3 9\n4 5 6 9\n").warnings ==
        std::vector<std::string>{"lines with more values than the header describes: 2"});
  CHECK(read_as("a.ply", header + "1 2 3\n4 5 6\n7 8 9\n").warnings.size() == 1);
  const std::string binary =
      "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty uchar x\nproperty uchar y\n"
      "property uchar z\nend_header\nabc";
  CHECK(read_as("a.ply", binary).warnings.empty());
  CHECK(read_as("a.ply", binary + "d").warnings.size() == 1);
}
