// The hierarchy against brute force.
#include "render/triangle_tree.h"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "scenes.h"

using namespace archetype;

namespace {

std::optional<TriangleHit> brute_force(const std::vector<glm::vec3>& corners, const Ray& ray) {
  std::optional<TriangleHit> best;
  for (std::uint32_t t = 0; 3 * t < corners.size(); ++t) {
    const auto distance =
        intersect_triangle(ray.origin, ray.direction, corners[3 * t], corners[3 * t + 1], corners[3 * t + 2]);
    if (distance && *distance >= 0 && (!best || *distance < best->distance)) best = TriangleHit{t, *distance};
  }
  return best;
}

}  // namespace

TEST_CASE("the tree finds what brute force finds") {
  const auto geometry = geometry_of(random_soup(400, 3));
  RandomStream random(5);
  int hits = 0;
  for (int i = 0; i < 4000; ++i) {
    const auto within = [&] {
      return glm::dvec3(random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2));
    };
    Ray ray{within(), within()};
    if (i % 5 == 0) ray.direction = {0, 0, i % 2 == 0 ? 1 : -1};  // along an axis: zeros in the slabs
    const auto expected = brute_force(geometry->positions, ray);
    const auto found = geometry->tree.first_hit(geometry->positions, ray.origin, ray.direction);
    REQUIRE(found.has_value() == expected.has_value());
    if (!found) continue;
    ++hits;
    CHECK(found->triangle == expected->triangle);
    CHECK(found->distance == expected->distance);
  }
  CHECK(hits > 500);
}

TEST_CASE("no ray slips through the edges of a closed surface") {
  // A fan about the z axis: every ray goes exactly through an edge or the hub.
  std::vector<glm::vec3> corners;
  constexpr int sectors = 37;
  const auto rim = [](int i) {
    return glm::vec3(std::cos(i % sectors * 0.17F), std::sin(i % sectors * 0.17F),
                     0.1F * static_cast<float>(i % 3));
  };
  for (int i = 0; i < sectors; ++i) corners.insert(corners.end(), {glm::vec3(0), rim(i), rim(i + 1)});
  const TriangleTree tree(corners);
  for (int i = 0; i < sectors; ++i)
    for (const double share : {0.0, 0.1, 1.0 / 3, 0.77}) {
      const glm::dvec3 on_edge = share * glm::dvec3(rim(i));
      CHECK(tree.first_hit(corners, on_edge + glm::dvec3(0, 0, 3), {0, 0, -1}));
    }
}

TEST_CASE("degenerate, infinite and missing triangles do no harm") {
  const float infinite = std::numeric_limits<float>::infinity();
  const std::vector<glm::vec3> corners{{0, 0, 0},   {0, 0, 0},   {0, 0, 0},  {infinite, 0, 0}, {0, 1, 0},
                                       {1, 0, NAN}, {-1, -1, 1}, {1, -1, 1}, {0, 1, 1}};
  const TriangleTree tree(corners);
  const auto hit = tree.first_hit(corners, {0, 0, -5}, {0, 0, 1});
  REQUIRE(hit);
  CHECK(hit->triangle == 2);
  CHECK(hit->distance == 6);
  CHECK_FALSE(tree.first_hit(corners, {0, 0, -5}, {0, 0, 1}, 6.0));
  CHECK_FALSE(TriangleTree().first_hit({}, {0, 0, 0}, {0, 0, 1}));
}
