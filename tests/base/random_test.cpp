#include "core/base/random.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace archetype;

TEST_CASE("a stream repeats for its seed and differs for another") {
  RandomStream a(7);
  RandomStream b(7);
  RandomStream c(8);
  bool differs = false;
  for (int i = 0; i < 100; ++i) {
    const auto value = a.next();
    CHECK(value == b.next());
    differs |= value != c.next();
  }
  CHECK(differs);
}

TEST_CASE("uniform and normal numbers have their moments") {
  RandomStream random(1);
  const int n = 200000;
  double uniform = 0;
  double mean = 0;
  double square = 0;
  for (int i = 0; i < n; ++i) {
    const double u = random.uniform();
    REQUIRE(u >= 0);
    REQUIRE(u < 1);
    uniform += u;
    const double x = random.normal();
    mean += x;
    square += x * x;
    REQUIRE(random.below(3) < 3);
  }
  CHECK(uniform / n == doctest::Approx(0.5).epsilon(0.01));
  CHECK(std::abs(mean / n) < 0.01);
  CHECK(square / n == doctest::Approx(1).epsilon(0.02));
}

TEST_CASE("a subset is in order, repeats for its seed, and holds each number as often as any other") {
  CHECK(random_subset(5, 5, 1) == std::vector<std::size_t>{0, 1, 2, 3, 4});
  CHECK(random_subset(3, 7, 1).size() == 3);
  CHECK(random_subset(0, 7, 1).empty());
  CHECK(random_subset(100, 10, 3) == random_subset(100, 10, 3));
  CHECK(random_subset(100, 10, 3) != random_subset(100, 10, 4));
  std::vector<int> drawn(20, 0);
  for (std::uint64_t seed = 0; seed < 4000; ++seed) {
    const std::vector<std::size_t> subset = random_subset(drawn.size(), 5, seed);
    REQUIRE(subset.size() == 5);
    CHECK(std::ranges::is_sorted(subset));
    CHECK(std::ranges::adjacent_find(subset) == subset.end());
    for (const std::size_t i : subset) ++drawn.at(i);
  }
  // Each is expected 1000 times, with a standard deviation of 27.
  for (const int times : drawn) CHECK(std::abs(times - 1000) < 120);
}
