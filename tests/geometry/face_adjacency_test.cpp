#include "core/geometry/face_adjacency.h"

#include <doctest/doctest.h>

#include <numbers>

using namespace archetype;

namespace {

// A unit cube of six outward quads; `separate` gives every face corners of its own.
PolygonMesh cube(bool separate) {
  PolygonMesh mesh;
  const std::uint32_t faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                     {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  const auto corner = [](std::uint32_t i) { return Vec3(i & 1, (i >> 1) & 1, i >> 2); };
  if (!separate) {
    for (std::uint32_t i = 0; i < 8; ++i) mesh.vertices.push_back(corner(i));
  }
  for (const auto& face : faces) {
    std::vector<std::uint32_t> corners(face, face + 4);
    if (separate) {
      for (auto& c : corners) {
        mesh.vertices.push_back(corner(c));
        c = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
      }
    }
    mesh.add_face(corners);
  }
  return mesh;
}

}  // namespace

TEST_CASE("a cube has twelve convex right-angled edges, also when its faces own their corners") {
  for (const bool separate : {false, true}) {
    const FaceAdjacency adjacency = find_adjacent_faces(cube(separate));
    CHECK(adjacency.pairs.size() == 12);
    CHECK(adjacency.shared_share == 1);
    for (const FacePair& pair : adjacency.pairs) {
      CHECK(pair.angle == doctest::Approx(std::numbers::pi / 2));
      CHECK(pair.length == doctest::Approx(1));
      CHECK(pair.convex);
    }
  }
}

TEST_CASE("a cube turned inside out is still convex") {
  PolygonMesh mesh = cube(false);
  for (std::size_t f = 0; f < 6; ++f) {
    std::reverse(mesh.face_corners.begin() + mesh.face_begins[f],
                 mesh.face_corners.begin() + mesh.face_begins[f + 1]);
  }
  for (const FacePair& pair : find_adjacent_faces(mesh).pairs) CHECK(pair.convex);
}

TEST_CASE("edges of one, three and degenerate faces join nothing") {
  PolygonMesh mesh;
  for (int i = 0; i < 5; ++i) mesh.vertices.emplace_back(i, i * i, i % 2);
  for (const std::uint32_t apex : {2U, 3U, 4U}) mesh.add_face(std::array<std::uint32_t, 3>{0, 1, apex});
  mesh.add_face(std::array<std::uint32_t, 3>{1, 1, 1});
  mesh.add_face(std::span<const std::uint32_t>{});
  CHECK(find_adjacent_faces(mesh).pairs.empty());
  CHECK(find_adjacent_faces({}).pairs.empty());
}

TEST_CASE("faces with a corner at the same place are one component, numbered by their first faces") {
  PolygonMesh mesh;
  const auto triangle = [&](double x, double y) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const Vec3& corner : {Vec3(x, y, 0), Vec3(x + 1, y, 0), Vec3(x, y + 1, 0)})
      mesh.vertices.push_back(corner);
    const std::uint32_t corners[] = {first, first + 1, first + 2};
    mesh.add_face(corners);
  };
  triangle(0, 0);
  triangle(5, 0);
  triangle(1, 0);  // has a corner of the first one, of its own
  mesh.add_face({});
  triangle(6, 0);
  triangle(9, 9);
  CHECK(face_components(mesh) == std::vector<std::uint32_t>{0, 1, 0, 2, 1, 3});
  CHECK(face_components({}).empty());
}
