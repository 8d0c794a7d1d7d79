// What is painted lies on the surface in smooth patches, however large its faces are.
#include "ui/painted_surface.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/base/random.h"

using namespace archetype;

namespace {

// Two triangles, 4 wide and high, or a sheet with another one below it.
MeshGeometry sheet(bool two) {
  MeshGeometry mesh;
  for (const float z : {0.F, -0.05F}) {
    const glm::vec3 corners[] = {{-2, -2, z}, {2, -2, z}, {2, 2, z}, {-2, -2, z}, {2, 2, z}, {-2, 2, z}};
    mesh.positions.insert(mesh.positions.end(), std::begin(corners), std::end(corners));
    mesh.normals.insert(mesh.normals.end(), 6, glm::vec3(0, 0, 1));
    mesh.faces.insert(mesh.faces.end(), {0, 0});
    if (!two) break;
  }
  mesh.face_count = 1;
  return mesh;
}

// About 0.1 apart, not in rows.
PointGeometry samples_on(bool two) {
  PointGeometry points;
  points.spacing = 0.1F;
  RandomStream random(7);
  for (const float z : {0.F, -0.05F}) {
    for (int x = -20; x < 20; ++x)
      for (int y = -20; y < 20; ++y)
        points.positions.emplace_back(0.1 * (x + 0.9 * random.uniform()), 0.1 * (y + 0.9 * random.uniform()),
                                      z);
    if (!two) break;
  }
  return points;
}

double area_of(const MeshGeometry& mesh) {
  double area = 0;
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i)
    area +=
        0.5 * static_cast<double>(glm::length(glm::cross(mesh.positions[3 * i + 1] - mesh.positions[3 * i],
                                                         mesh.positions[3 * i + 2] - mesh.positions[3 * i])));
  return area;
}

}  // namespace

TEST_CASE("A stripe over two large faces has straight edges, on either side of the sheet") {
  for (const bool two : {false, true}) {
    CAPTURE(two);
    const MeshGeometry mesh = sheet(two);
    const PointGeometry samples = samples_on(two);
    std::vector<PinnedLabel> pinned;
    for (std::uint32_t i = 0; i < samples.positions.size(); ++i) {
      const glm::vec3 at = samples.positions[i];
      if (std::abs(at.y) < 0.3F && std::abs(at.x) < 1.5F && at.z == 0) pinned.push_back({i, 3});
    }
    const auto patches = painted_patches(mesh, samples, pinned);
    REQUIRE(patches.size() == 1);
    CHECK(patches[0].label == 3);
    const MeshGeometry& patch = *patches[0].geometry;
    CHECK(patch.positions.size() == 3 * patch.triangle_count());
    CHECK(patch.normals.size() == patch.positions.size());
    // 3 by 0.6, above and below.
    if (!two) CHECK(area_of(patch) == doctest::Approx(2 * 1.8).epsilon(0.08));
    double highest_error = 0;
    for (const glm::vec3& at : patch.positions) {
      CHECK(std::abs(at.z) < (two ? 0.06F : 0.01F));
      highest_error = std::max(highest_error, static_cast<double>(std::abs(at.y)) - 0.3);
    }
    CHECK(highest_error < 0.05);  // half the distance of neighbouring samples
    // No notch comes into the stripe: its middle is covered.
    double covered = 0;
    for (std::size_t i = 0; i < patch.triangle_count(); ++i) {
      const glm::vec3 middle =
          (patch.positions[3 * i] + patch.positions[3 * i + 1] + patch.positions[3 * i + 2]) / 3.F;
      if (middle.z < 0 || std::abs(middle.y) > 0.23F || std::abs(middle.x) > 1.4F) continue;
      covered += 0.5 * static_cast<double>(
                           glm::length(glm::cross(patch.positions[3 * i + 1] - patch.positions[3 * i],
                                                  patch.positions[3 * i + 2] - patch.positions[3 * i])));
    }
    CHECK(covered == doctest::Approx(2.8 * 0.46).epsilon(0.06));
  }
}

TEST_CASE("Each label has a patch of its own; nothing painted, and broken input, have none") {
  const MeshGeometry mesh = sheet(false);
  PointGeometry samples = samples_on(false);
  CHECK(painted_patches(mesh, samples, {}).empty());
  std::vector<PinnedLabel> pinned;
  for (std::uint32_t i = 0; i < samples.positions.size(); ++i)
    pinned.push_back({i, static_cast<std::int16_t>(samples.positions[i].x < 0 ? 0 : null_label)});
  const auto patches = painted_patches(mesh, samples, pinned);
  REQUIRE(patches.size() == 2);
  CHECK(patches[0].label == null_label);
  CHECK(area_of(*patches[0].geometry) == doctest::Approx(2 * 8).epsilon(0.03));
  CHECK(area_of(*patches[1].geometry) == doctest::Approx(2 * 8).epsilon(0.03));
  CHECK(painted_patches(mesh, samples, std::vector<PinnedLabel>{{1'000'000, 0}}).empty());
  samples.spacing = 0;
  CHECK(painted_patches(mesh, samples, pinned).empty());
}
