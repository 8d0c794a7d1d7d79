#include "core/base/random.h"

#include <doctest/doctest.h>

#include <cmath>

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
