#include "core/geometry/kd_tree.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "core/base/random.h"

using namespace archetype;

namespace {

std::vector<Vec3> cloud(std::size_t n, RandomStream& random, int grid) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < n; ++i) {
    // On a coarse grid many distances are equal, and many points are the same.
    points.emplace_back(static_cast<double>(random.below(static_cast<std::uint64_t>(grid))),
                        static_cast<double>(random.below(static_cast<std::uint64_t>(grid))),
                        static_cast<double>(random.below(static_cast<std::uint64_t>(grid))));
  }
  return points;
}

}  // namespace

TEST_CASE("neighbours are those of brute force, ties by index") {
  RandomStream random(11);
  std::vector<KdTree::Neighbour> found;
  for (const int grid : {3, 10, 1000000}) {
    const auto points = cloud(700, random, grid);
    const KdTree tree(points);
    for (int q = 0; q < 100; ++q) {
      const Vec3 p = cloud(1, random, grid)[0] + Vec3(0.25, 0.5, 0);
      std::vector<std::pair<double, std::uint32_t>> all;
      for (std::uint32_t i = 0; i < points.size(); ++i) all.emplace_back((points[i] - p).squaredNorm(), i);
      std::sort(all.begin(), all.end());
      CHECK(tree.nearest(p).index == all[0].second);
      for (const std::size_t k : {1U, 7U, 700U, 900U}) {
        tree.nearest(p, k, found);
        REQUIRE(found.size() == std::min<std::size_t>(k, points.size()));
        for (std::size_t i = 0; i < found.size(); ++i) REQUIRE(found[i].index == all[i].second);
      }
      std::vector<std::int16_t> labels;
      for (std::size_t i = 0; i < points.size(); ++i) labels.push_back(static_cast<std::int16_t>(i % 3));
      const auto labelled =
          std::find_if(all.begin(), all.end(), [&](const auto& a) { return labels[a.second] == 2; });
      for (const std::uint32_t hint : {2U, 3U, 699U, labelled->second}) {
        REQUIRE(tree.nearest_labelled(p, labels, 2, hint) == labelled->second);
      }
      const double reach = std::sqrt(all[50].first);
      tree.nearest(p, 20, found, reach);
      REQUIRE(found.size() == 20);
      tree.within(p, reach, found);
      const auto inside =
          std::count_if(all.begin(), all.end(), [&](const auto& a) { return a.first <= reach * reach; });
      REQUIRE(found.size() == static_cast<std::size_t>(inside));
    }
  }
}
