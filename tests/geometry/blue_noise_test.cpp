#include "core/geometry/blue_noise.h"

#include <doctest/doctest.h>

#include "core/base/random.h"
#include "core/geometry/kd_tree.h"

using namespace archetype;

TEST_CASE("what is kept lies evenly: no two points close, no place empty") {
  RandomStream random(2);
  std::vector<Vec3> square;
  for (int i = 0; i < 4000; ++i) square.emplace_back(random.uniform(), random.uniform(), 0);
  const auto kept = eliminate_samples(square, 1000, 1.0);
  REQUIRE(kept.size() == 1000);
  CHECK(std::is_sorted(kept.begin(), kept.end()));
  std::vector<Vec3> points;
  for (const auto i : kept) points.push_back(square[i]);
  const KdTree tree(points);
  std::vector<KdTree::Neighbour> near;
  double smallest = 1;
  for (const Vec3& p : points) {
    tree.nearest(p, 2, near);
    smallest = std::min(smallest, std::sqrt(near[1].squared_distance));
  }
  // A perfect hexagonal packing has 0.034; independent draws of 1,000 points have about 0.0005.
  CHECK(smallest > 0.012);
  for (int q = 0; q < 500; ++q) {
    CHECK(tree.nearest(Vec3(random.uniform(), random.uniform(), 0)).squared_distance < 0.05 * 0.05);
  }
}

TEST_CASE("points piled on one place neither hang nor vanish") {
  const std::vector<Vec3> pile(5000, Vec3(1, 2, 3));
  CHECK(eliminate_samples(pile, 100, 1.0).size() == 100);
  CHECK(eliminate_samples(pile, 6000, 1.0).size() == 5000);
}
