// glTF and GLB: arrays of all kinds, the scene's tree, and what files may be opened.
#include <doctest/doctest.h>

#include <cstring>

#include "core/base/error.h"
#include "core/io/file.h"
#include "tests/io/gltf_builder.h"
#include "tests/io/shape_reading.h"

using namespace archetype;
using namespace archetype::test;

namespace {

const std::vector<double> square{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
const std::vector<Vec3> square_vertices{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)};
const std::string one_mesh =
    R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],"nodes":[{"mesh":0}])";

GltfBuilder square_builder() {
  GltfBuilder builder;
  builder.positions(square);
  builder.indices({0, 1, 2, 0, 2, 3, 3, 3, 1});
  return builder;
}
const Faces square_faces{{0, 1, 2}, {0, 2, 3}, {3, 3, 1}};

}  // namespace

TEST_CASE("glTF with an embedded buffer, with one in a file, and GLB read the same") {
  const GltfBuilder builder = square_builder();
  const ScratchFolder folder;
  folder.write("sub/my buffer+.bin", builder.data());
  const auto embedded = read_shape(folder.write("a.gltf", builder.embedded(one_mesh)));
  const auto external = read_shape(folder.write("b.gltf", builder.json("sub/my%20buffer+.b%69n", one_mesh)));
  const auto binary = read_shape(folder.write("c.GLB", builder.binary(one_mesh)));
  for (const ShapeFile& shape : {embedded, external, binary}) {
    CHECK(faces(shape.mesh) == square_faces);
    CHECK(shape.mesh.vertices == square_vertices);
  }
  // The hash covers the buffer's file too.
  folder.write("sub/my buffer+.bin", builder.data() + " ");
  CHECK(read_shape(folder.path() / "b.gltf").hash != external.hash);
}

TEST_CASE("glTF buffers are never read from outside the file's folder") {
  const GltfBuilder builder = square_builder();
  const ScratchFolder folder;
  folder.write("secret.bin", builder.data());
  folder.write("in/beside.bin", builder.data());
  std::filesystem::create_symlink(folder.path() / "secret.bin", folder.path() / "in/link.bin");
  std::filesystem::create_directory_symlink(folder.path(), folder.path() / "in/up");
  std::filesystem::create_symlink("beside.bin", folder.path() / "in/good-link.bin");
  const auto read = [&](const std::string& uri) {
    return read_shape(folder.write("in/a.gltf", builder.json(uri, one_mesh)));
  };
  for (const char* uri : {"beside.bin", "./beside.bin", "good-link.bin"}) {
    CHECK(read(uri).mesh.face_count() == 3);
  }
  for (const std::string& uri :
       {std::string("../secret.bin"), std::string("%2e%2e/secret.bin"), std::string("..%2Fsecret.bin"),
        std::string("x/../../secret.bin"), (folder.path() / "secret.bin").string(), std::string("link.bin"),
        std::string("up/secret.bin"), "file://" + (folder.path() / "secret.bin").string(),
        std::string("..\\\\secret.bin"), std::string("http://127.0.0.1/secret.bin"),
        std::string("beside.bin%00"), std::string("%zz"), std::string("%2"), std::string("missing.bin"),
        std::string("."), std::string("")}) {
    CAPTURE(uri);
    CHECK_THROWS_AS(read(uri), Error);
  }
}

TEST_CASE("glTF pictures are never opened") {
  const ShapeFile shape =
      read_as("a.gltf", square_builder().embedded(one_mesh + R"(,"images":[{"uri":"/dev/zero"},
      {"bufferView":99},{"uri":"data:image/png;base64,AAAA"}],"textures":[{"source":7}])"));
  CHECK(shape.mesh.face_count() == 3);
}

TEST_CASE("glTF nodes: transforms accumulate, a mesh may stand in several places") {
  GltfBuilder builder;
  builder.positions({1, 2, 3});
  const std::string meshes = R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"mode":0}]}],)";
  const auto points = [&](const std::string& rest) {
    return read_as("a.gltf", builder.embedded(meshes + rest)).mesh.vertices;
  };
  // Column-major matrix: a quarter turn about z, then a shift.
  CHECK(points(R"("nodes":[{"mesh":0,"matrix":[0,1,0,0,-1,0,0,0,0,0,1,0,10,0,0,1]}])") ==
        std::vector<Vec3>{Vec3(8, 1, 3)});
  const auto turned = points(R"("nodes":[{"mesh":0,"children":[1],"translation":[10,0,0]},
      {"mesh":0,"rotation":[0,0,0.7071067811865476,0.7071067811865476],"scale":[2,2,2],"translation":[0,0,1]}])");
  REQUIRE(turned.size() == 2);
  CHECK(turned[0] == Vec3(11, 2, 3));
  CHECK(turned[1].isApprox(Vec3(10 - 4, 2, 7)));
  // Only what the scene names; children come depth first.
  CHECK(
      points(R"("scene":1,"scenes":[{"nodes":[2]},{"nodes":[1,0]}],"nodes":[{"mesh":0,"translation":[1,0,0]},
      {"children":[3]},{"mesh":0,"translation":[2,0,0]},{"mesh":0,"translation":[3,0,0]}])") ==
      std::vector<Vec3>{Vec3(4, 2, 3), Vec3(2, 2, 3)});
  // Without nodes all meshes stand as they are.
  CHECK(points(R"("extras":1)") == std::vector<Vec3>{Vec3(1, 2, 3)});
}

TEST_CASE("glTF nodes that contain themselves, or are contained twice, are refused") {
  for (const char* nodes :
       {R"([{"mesh":0,"children":[0]}],"scenes":[{"nodes":[0]}])",
        R"([{"children":[1]},{"mesh":0,"children":[0]}],"scenes":[{"nodes":[0]}])",
        R"([{"children":[1,1]},{"mesh":0}])", R"([{"mesh":0}],"scenes":[{"nodes":[0,0]}])"}) {
    CAPTURE(nodes);
    CHECK_THROWS_WITH_AS(
        read_as("a.gltf", square_builder().embedded(
                              R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"nodes":)" +
                              std::string(nodes))),
        doctest::Contains("is contained twice, or contains itself"), InputError);
  }
}

TEST_CASE("a long chain of glTF nodes is read without recursion") {
  std::string nodes =
      R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],"nodes":[{"mesh":0})";
  const int depth = 50000;
  for (int i = 0; i < depth; ++i)
    nodes += R"(,{"translation":[1,0,0],"children":[)" + std::to_string(i) + "]}";
  const PolygonMesh mesh = read_as("a.gltf", square_builder().embedded(nodes + "]")).mesh;
  CHECK(mesh.vertices[0] == Vec3(depth, 0, 0));
}

TEST_CASE("glTF arrays: interleaved, sparse, with an offset, of small integers and normalised") {
  GltfBuilder builder;
  std::vector<double> interleaved;
  for (std::size_t i = 0; i < square.size(); i += 3) {
    interleaved.insert(interleaved.end(), {9, square[i], square[i + 1], square[i + 2], 9});
  }
  builder.accessor(builder.view<float>(interleaved, 20), 5126, "VEC3", 4, R"("byteOffset":4)");
  builder.accessor(builder.view<std::uint8_t>({9, 9, 9, 9, 0, 1, 2}), 5121, "SCALAR", 3, R"("byteOffset":4)");
  CHECK(read_as("a.glb", builder.binary(one_mesh)).mesh.vertices == square_vertices);

  GltfBuilder sparse;
  sparse.positions(square);
  const int places = sparse.view<std::uint32_t>({1, 3});
  const int values = sparse.view<float>({5, 5, 5, 6, 6, 6});
  const std::string replaced = R"("sparse":{"count":2,"indices":{"bufferView":)" + std::to_string(places) +
                               R"(,"componentType":5125},"values":{"bufferView":)" + std::to_string(values) +
                               "}}";
  sparse.accessor(0, 5126, "VEC3", 4, replaced);
  sparse.accessor(-1, 5126, "VEC3", 4, replaced);
  const auto points = [&](const GltfBuilder& with, int accessor) {
    return read_as("a.glb", with.binary(R"("meshes":[{"primitives":[{"mode":0,"attributes":{"POSITION":)" +
                                        std::to_string(accessor) + "}}]}]"))
        .mesh.vertices;
  };
  CHECK(points(sparse, 1) == std::vector<Vec3>{Vec3(0, 0, 0), Vec3(5, 5, 5), Vec3(1, 1, 0), Vec3(6, 6, 6)});
  CHECK(points(sparse, 2) == std::vector<Vec3>{Vec3(0, 0, 0), Vec3(5, 5, 5), Vec3(0, 0, 0), Vec3(6, 6, 6)});

  GltfBuilder quantised;
  quantised.accessor(quantised.view<std::int8_t>({-128, -127, 127}), 5120, "VEC3", 1, R"("normalized":true)");
  quantised.accessor(quantised.view<std::uint16_t>({0, 65535, 257}), 5123, "VEC3", 1, R"("normalized":true)");
  quantised.accessor(quantised.view<std::int16_t>({-300, 0, 7}), 5122, "VEC3", 1);
  CHECK(points(quantised, 0) == std::vector<Vec3>{Vec3(-1, -1, 1)});
  CHECK(points(quantised, 1) == std::vector<Vec3>{Vec3(0, 1, 257.0 / 65535)});
  CHECK(points(quantised, 2) == std::vector<Vec3>{Vec3(-300, 0, 7)});
}

TEST_CASE("glTF strips, fans, triangles without indices; lines are passed over; equal vertices are joined") {
  GltfBuilder builder;
  builder.positions({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0});
  const int doubled = builder.positions({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0, 7, 7, 7});
  REQUIRE(doubled == 1);
  const auto read = [&](const std::string& primitives) {
    return read_as("a.glb", builder.binary(R"("meshes":[{"primitives":[)" + primitives + "]}]"));
  };
  CHECK(faces(read(R"({"mode":5,"attributes":{"POSITION":0}})").mesh) ==
        Faces{{0, 1, 2}, {1, 3, 2}, {2, 3, 4}});
  CHECK(faces(read(R"({"mode":6,"attributes":{"POSITION":0}})").mesh) ==
        Faces{{1, 2, 0}, {2, 3, 0}, {3, 4, 0}});
  const ShapeFile both = read(R"({"attributes":{"POSITION":1}},{"mode":1,"attributes":{"POSITION":0}},
      {"mode":0,"attributes":{"POSITION":0}},{"mode":4,"attributes":{"POSITION":1}})");
  CHECK(faces(both.mesh) == Faces{{0, 1, 2}, {2, 1, 3}, {0, 1, 2}, {2, 1, 3}});
  CHECK(both.warnings.size() == 3);  // points, lines, and a seventh corner
}

TEST_CASE("glTF buffers that are too large together are refused before they are read") {
  const ScratchFolder folder;
  const GltfBuilder builder = square_builder();
  folder.write("small.bin", builder.data());
  folder.write("large.bin", "");
  std::filesystem::resize_file(folder.path() / "large.bin", max_file_bytes);  // takes no room on the disk
  const auto path =
      folder.write("a.gltf", R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":4,"uri":"small.bin"},
                 {"byteLength":4,"uri":"large.bin"}]})");
  CHECK_THROWS_WITH(read_shape(path), doctest::Contains("buffers[1]: the buffers hold more than"));
}
