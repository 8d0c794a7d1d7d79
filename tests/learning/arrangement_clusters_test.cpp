#include "core/learning/arrangement_clusters.h"

#include <doctest/doctest.h>

#include "core/base/random.h"

using namespace archetype;

namespace {

using Observed = std::vector<std::vector<PartObservation>>;

// Shapes of two parts whose second one lies `apart` from the first, more or less.
void add_shapes(Observed& observed, std::size_t count, double apart, bool second, RandomStream& random) {
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<PartObservation> shape(2);
    shape[0].present = true;
    shape[1].present = second;
    for (PartObservation& part : shape) {
      part.box.centre = 0.03 * Vec3(random.normal(), random.normal(), random.normal());
      part.box.half_extent = Vec3::Constant(0.3 + 0.01 * random.normal());
    }
    shape[1].box.centre.x() += apart;
    observed.push_back(shape);
  }
}

}  // namespace

TEST_CASE("arrangements that differ are told apart, and nothing else") {
  RandomStream random(1);
  Observed observed;
  add_shapes(observed, 12, 0.5, true, random);
  CHECK(arrangement_clusters(observed, {}).size() == 1);
  add_shapes(observed, 8, 1.4, true, random);
  const auto clusters = arrangement_clusters(observed, {});
  REQUIRE(clusters.size() == 2);
  CHECK(clusters[0].size() == 12);
  CHECK(clusters[0].front() == 0);
  CHECK(clusters[1].front() == 12);
  CHECK(clusters[1].size() == 8);
}

TEST_CASE("shapes with other parts are never of one cluster, and a few make none") {
  RandomStream random(2);
  Observed observed;
  add_shapes(observed, 6, 0.5, true, random);
  add_shapes(observed, 5, 0.5, false, random);
  CHECK(arrangement_clusters(observed, {}).size() == 2);
  Observed few;
  add_shapes(few, 2, 0.5, true, random);
  CHECK(arrangement_clusters(few, {}).empty());
  CHECK(arrangement_clusters({}, {}).empty());
}
