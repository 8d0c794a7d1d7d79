#include "core/geometry/surface_search.h"

#include <doctest/doctest.h>

#include <limits>

#include "core/base/random.h"

using namespace archetype;

namespace {

Vec3 random_point(RandomStream& random) {
  return {random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5};
}

Vec3 place(const Triangle& triangle, const Vec3& weights) {
  return weights[0] * triangle[0] + weights[1] * triangle[1] + weights[2] * triangle[2];
}

std::vector<Triangle> soup(std::size_t count, double size) {
  RandomStream random(1);
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 centre = random_point(random);
    Triangle triangle;
    for (Vec3& corner : triangle) corner = centre + size * random_point(random);
    if (i % 7 == 0) triangle[2] = triangle[1];            // a segment
    if (i % 11 == 0) triangle[1] = triangle[2] = centre;  // nearly a point
    triangles.push_back(triangle);
  }
  return triangles;
}

}  // namespace

TEST_CASE("no other point of a triangle is nearer") {
  RandomStream random(2);
  for (const Triangle& triangle : soup(200, 1)) {
    const Vec3 p = 2 * random_point(random);
    const SurfacePoint found = closest_on_triangle(triangle, p);
    CHECK(found.weights.minCoeff() >= 0);
    CHECK(found.weights.sum() == doctest::Approx(1));
    CHECK((place(triangle, found.weights) - p).squaredNorm() == doctest::Approx(found.squared_distance));
    for (int i = 0; i < 200; ++i) {
      Vec3 weights(random.uniform(), random.uniform(), random.uniform());
      weights /= weights.sum();
      CHECK((place(triangle, weights) - p).squaredNorm() >= found.squared_distance - 1e-12);
    }
  }
}

TEST_CASE("the search finds what looking at every triangle finds") {
  for (const double size : {0.02, 0.3, 2.0}) {
    const std::vector<Triangle> triangles = soup(500, size);
    const SurfaceSearch search(triangles);
    RandomStream random(3);
    for (int i = 0; i < 300; ++i) {
      const Vec3 p = 1.5 * random_point(random);
      SurfacePoint best;
      best.squared_distance = std::numeric_limits<double>::infinity();
      for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        const SurfacePoint point = closest_on_triangle(triangles[t], p);
        if (point.squared_distance >= best.squared_distance) continue;
        best = point;
        best.triangle = t;
      }
      const SurfacePoint found = search.nearest(p);
      CHECK(found.triangle == best.triangle);
      CHECK(found.squared_distance == best.squared_distance);
    }
  }
}

TEST_CASE("what is not finite is never found") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Triangle bad{Vec3(nan, 0, 0), Vec3(0, 0, 0), Vec3(0, 1, 0)};
  CHECK(SurfaceSearch({bad}).empty());
  const Triangle good{Vec3(9, 0, 0), Vec3(9, 1, 0), Vec3(9, 0, 1)};
  CHECK(SurfaceSearch({bad, good}).nearest(Vec3::Zero()).triangle == 1);
}
