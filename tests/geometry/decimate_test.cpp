// Coarser meshes: fewer triangles, the same shape, labels that still fit.
#include "core/geometry/decimate.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "core/base/random.h"

using namespace archetype;

namespace {

// A unit sphere of rings x sectors quads; each quad is a face, those at the poles are degenerate.
PolygonMesh sphere(std::uint32_t rings, std::uint32_t sectors) {
  PolygonMesh mesh;
  for (std::uint32_t i = 0; i <= rings; ++i)
    for (std::uint32_t j = 0; j < sectors; ++j) {
      const double polar = std::numbers::pi * i / rings;
      const double turn = 2 * std::numbers::pi * j / sectors;
      const double across = i == 0 || i == rings ? 0 : std::sin(polar);
      mesh.vertices.emplace_back(across * std::cos(turn), std::cos(polar), across * std::sin(turn));
    }
  for (std::uint32_t i = 0; i < rings; ++i)
    for (std::uint32_t j = 0; j < sectors; ++j) {
      const std::uint32_t next = (j + 1) % sectors;
      mesh.add_face(
          std::array{i * sectors + j, (i + 1) * sectors + j, (i + 1) * sectors + next, i * sectors + next});
    }
  return mesh;
}

double area(const PolygonMesh& mesh) {
  double sum = 0;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) sum += 0.5 * face_area_vector(mesh, f).norm();
  return sum;
}

}  // namespace

TEST_CASE("a decimated sphere is still one, with faces that lie where they came from") {
  const PolygonMesh fine = sphere(60, 120);
  const auto coarse = decimate(fine, 1000);
  REQUIRE(coarse);
  CHECK(coarse->mesh.face_count() <= 1000);
  CHECK(coarse->mesh.face_count() > 900);
  CHECK(coarse->faces.size() == coarse->mesh.face_count());
  CHECK(area(coarse->mesh) == doctest::Approx(area(fine)).epsilon(0.02));
  for (const Vec3& v : coarse->mesh.vertices) CHECK(v.norm() == doctest::Approx(1).epsilon(0.03));
  for (std::size_t f = 0; f < coarse->faces.size(); ++f)
    CHECK((face_centre(coarse->mesh, f) - face_centre(fine, coarse->faces[f])).norm() < 0.5);
}

TEST_CASE("decimation gives the same mesh each time") {
  const PolygonMesh fine = sphere(20, 30);
  const auto a = decimate(fine, 200);
  const auto b = decimate(fine, 200);
  REQUIRE((a && b));
  CHECK(a->mesh.face_corners == b->mesh.face_corners);
  CHECK(a->mesh.vertices == b->mesh.vertices);
  CHECK(a->faces == b->faces);
}

TEST_CASE("soups with every fault are decimated without complaint") {
  PolygonMesh soup = sphere(20, 30);
  RandomStream random(8);
  const std::size_t vertex_count = soup.vertices.size();
  for (int i = 0; i < 800; ++i) {
    // Faces between any vertices: non-manifold edges, duplicates, equal corners, flips.
    std::vector<std::uint32_t> corners(1 + random.below(5));
    for (auto& corner : corners) corner = static_cast<std::uint32_t>(random.below(vertex_count));
    soup.add_face(corners);
    if (i % 3 == 0) soup.add_face(corners);
  }
  soup.add_face(std::span<const std::uint32_t>{});
  const auto coarse = decimate(soup, 100);
  REQUIRE(coarse);
  CHECK(coarse->mesh.face_count() > 0);
  CHECK(coarse->mesh.face_count() < soup.face_count());
  for (const std::uint32_t face : coarse->faces) CHECK(face < soup.face_count());
  for (const std::uint32_t corner : coarse->mesh.face_corners) CHECK(corner < coarse->mesh.vertices.size());
}

TEST_CASE("a mesh that is coarse enough keeps its triangles, and nothing stays nothing") {
  CHECK(decimate(sphere(4, 8), 100'000)->mesh.face_count() == 4 * 8 * 2 - 2 * 8);
  CHECK(decimate(PolygonMesh{}, 10)->mesh.face_count() == 0);
}

TEST_CASE("a cancelled decimation gives nothing") {
  std::stop_source source;
  source.request_stop();
  CHECK_FALSE(decimate(sphere(40, 40), 10, JobControl{source.get_token(), {}}));
}
