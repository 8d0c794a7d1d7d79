#include "core/geometry/polygon_mesh.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>

#include "core/base/random.h"

using namespace archetype;

namespace {

double area_of(const PolygonMesh& mesh, const Triangulation& triangulation) {
  double sum = 0;
  for (const auto& [a, b, c] : triangulation.triangles) {
    sum += 0.5 * (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).norm();
  }
  return sum;
}

PolygonMesh polygon(const std::vector<Vec3>& corners) {
  PolygonMesh mesh;
  mesh.vertices = corners;
  std::vector<std::uint32_t> face(corners.size());
  for (std::uint32_t i = 0; i < face.size(); ++i) face[i] = i;
  mesh.add_face(face);
  return mesh;
}

}  // namespace

TEST_CASE("a polygon that is not convex is cut without leaving its outline") {
  // An L, a comb and a star: a fan from the first corner would cover more than their area.
  const PolygonMesh l = polygon({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}});
  CHECK(area_of(l, triangulate(l)) == doctest::Approx(4));
  std::vector<Vec3> comb{{0, 0, 0}, {10, 0, 0}};
  for (int i = 9; i >= 0; --i) {
    comb.emplace_back(i + 0.8, 5, 0);
    comb.emplace_back(i + 0.5, 1, 0);
  }
  for (int turn = 0; turn < 3; ++turn) {
    const PolygonMesh mesh = polygon(comb);
    const auto triangulation = triangulate(mesh);
    CHECK(triangulation.triangles.size() == comb.size() - 2);
    CHECK(area_of(mesh, triangulation) == doctest::Approx(0.5 * face_area_vector(mesh, 0).norm()));
    for (Vec3& p : comb) p = Vec3(p.y(), p.z(), p.x()) + Vec3(1, 2, 3);
  }
}

TEST_CASE("degenerate faces give no triangle and keep their number") {
  PolygonMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}};
  mesh.add_face(std::array<std::uint32_t, 2>{0, 1});
  mesh.add_face(std::array<std::uint32_t, 3>{0, 1, 2});
  mesh.add_face(std::array<std::uint32_t, 3>{0, 1, 3});
  mesh.add_face({});
  const auto triangulation = triangulate(mesh);
  REQUIRE(triangulation.faces.size() == 1);
  CHECK(triangulation.faces[0] == 2);
  CHECK(mesh.face_count() == 4);
}

TEST_CASE("any polygon ends, self-crossing and huge ones included") {
  RandomStream random(1);
  for (const int corners : {5, 40, 1500, 5000}) {
    std::vector<Vec3> points;
    for (int i = 0; i < corners; ++i) points.emplace_back(random.normal(), random.normal(), random.normal());
    CHECK(triangulate(polygon(points)).triangles.size() == static_cast<std::size_t>(corners) - 2);
  }
}
