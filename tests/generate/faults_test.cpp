#include "core/generate/faults.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/generate/generate.h"

using namespace archetype;

namespace {

struct Soup {
  PolygonMesh mesh;
  std::vector<int> labels;
};

Soup clean_chair() {
  GeneratedShape shape = generate_shape("chairs", {}, 1);
  return {std::move(shape.mesh), std::move(shape.labels)};
}

Soup with(const SoupFaults& faults) {
  Soup soup = clean_chair();
  add_faults(soup.mesh, soup.labels, faults, 5);
  REQUIRE(soup.labels.size() == soup.mesh.face_count());
  return soup;
}

std::vector<std::uint32_t> corners(const Soup& soup, std::size_t face) {
  const auto span = soup.mesh.face(face);
  return {span.begin(), span.end()};
}

bool near_share(std::size_t part, std::size_t whole, double share) {
  return std::abs(static_cast<double>(part) / static_cast<double>(whole) - share) < 0.05;
}

}  // namespace

TEST_CASE("flipped faces are turned, and no other") {
  const Soup clean = clean_chair();
  const Soup soup = with({.flipped = 0.3});
  REQUIRE(soup.mesh.face_count() == clean.mesh.face_count());
  std::size_t turned = 0;
  for (std::size_t f = 0; f < clean.mesh.face_count(); ++f) {
    std::vector<std::uint32_t> reversed = corners(clean, f);
    std::reverse(reversed.begin(), reversed.end());
    if (corners(soup, f) == reversed)
      ++turned;
    else
      REQUIRE(corners(soup, f) == corners(clean, f));
  }
  CHECK(soup.labels == clean.labels);
  CHECK(near_share(turned, clean.mesh.face_count(), 0.3));
}

TEST_CASE("duplicate faces stand beside their originals with the same label") {
  const Soup clean = clean_chair();
  const Soup soup = with({.duplicate = 0.4});
  std::size_t copies = 0;
  std::size_t turned = 0;
  std::size_t g = 0;
  for (std::size_t f = 0; f < clean.mesh.face_count(); ++f, ++g) {
    REQUIRE(corners(soup, g) == corners(clean, f));
    REQUIRE(soup.labels[g] == clean.labels[f]);
    if (g + 1 == soup.mesh.face_count()) continue;
    std::vector<std::uint32_t> next = corners(soup, g + 1);
    const bool same = next == corners(clean, f);
    std::reverse(next.begin(), next.end());
    if (same || next == corners(clean, f)) {
      ++copies;
      turned += same ? 0 : 1;
      ++g;
      REQUIRE(soup.labels[g] == clean.labels[f]);
    }
  }
  CHECK(g == soup.mesh.face_count());
  CHECK(near_share(copies, clean.mesh.face_count(), 0.4));
  CHECK(turned == copies / 2);
}

TEST_CASE("crossing faces stand at right angles through the middle of their originals") {
  const Soup clean = clean_chair();
  const Soup soup = with({.intersecting = 1});
  REQUIRE(soup.mesh.face_count() == 2 * clean.mesh.face_count());
  for (std::size_t f = 0; f < soup.mesh.face_count(); f += 2) {
    const Vec3 own = face_area_vector(soup.mesh, f);
    const Vec3 other = face_area_vector(soup.mesh, f + 1);
    CHECK(other.norm() == doctest::Approx(own.norm()).epsilon(1e-6));
    CHECK((face_centre(soup.mesh, f) - face_centre(soup.mesh, f + 1)).norm() < 1e-9);
    if (soup.mesh.face(f).size() == 3) CHECK(std::abs(own.normalized().dot(other.normalized())) < 1e-6);
    CHECK(soup.labels[f] == soup.labels[f + 1]);
  }
}

TEST_CASE("fins make edges with more than two faces") {
  const Soup soup = with({.non_manifold = 1});
  for (std::size_t f = 0; f < soup.mesh.face_count(); f += 2) {
    const auto face = soup.mesh.face(f);
    const auto fin = soup.mesh.face(f + 1);
    REQUIRE(fin.size() == 3);
    CHECK(fin[0] == face[0]);
    CHECK(fin[1] == face[1]);
    CHECK(face_area_vector(soup.mesh, f + 1).norm() > 0);
  }
}

TEST_CASE("degenerate faces have no area, half by equal corners and half by corners on a line") {
  const Soup soup = with({.degenerate = 1});
  std::size_t equal = 0;
  for (std::size_t f = 1; f < soup.mesh.face_count(); f += 2) {
    CHECK(face_area_vector(soup.mesh, f).norm() < 1e-12);
    if (soup.mesh.face(f)[0] == soup.mesh.face(f)[1]) ++equal;
  }
  CHECK(equal == (soup.mesh.face_count() / 2 + 1) / 2);
}
