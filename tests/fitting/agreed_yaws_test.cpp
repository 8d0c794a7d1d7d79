#include "core/fitting/agreed_yaws.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "tests/support/made_shapes.h"

using namespace archetype;

namespace {

using Energies = std::array<double, 4>;

std::size_t cheapest(const Energies& energies, const Energies& costs = {}) {
  std::size_t best = 0;
  for (std::size_t yaw = 1; yaw < 4; ++yaw) {
    if (energies[yaw] + costs[yaw] < energies[best] + costs[best]) best = yaw;
  }
  return best;
}

struct Collection {
  std::vector<ShapeSamples> samples;
  std::vector<std::size_t> yaws;   // as they stand
  std::vector<Energies> energies;  // of fits that find them

  Collection(const std::string& family, const std::vector<std::string>& styles, std::size_t count) {
    GenerateOptions options;
    options.styles = styles;
    options.yaw = YawChoice::quarters;
    for (std::size_t i = 0; i < count; ++i) {
      test::MadeShape shape = test::make_shape(family, options, i, 500);
      yaws.push_back(static_cast<std::size_t>(std::lround(shape.generated.yaw_degrees / 90)) % 4);
      samples.push_back(std::move(shape.samples));
      Energies& each = energies.emplace_back(Energies{0.6, 0.6, 0.6, 0.6});
      each[yaws[i]] = 0.5;
    }
  }
  // The fit of shape i is a little better turned by `quarters`.
  void mislead(std::size_t i, std::size_t quarters) { energies[i][(yaws[i] + quarters) % 4] = 0.45; }
};

}  // namespace

TEST_CASE("shapes whose fits stand wrongly turn as those that look like them") {
  Collection chairs("chairs", {"plain", "arms", "swivel"}, 16);
  chairs.mislead(2, 1);
  chairs.mislead(5, 2);
  chairs.mislead(11, 3);
  CHECK(cheapest(chairs.energies[2]) != chairs.yaws[2]);
  const AgreedYaws agreed(chairs.samples, chairs.energies);
  for (std::size_t i = 0; i < chairs.samples.size(); ++i) {
    const Energies costs = agreed.costs(chairs.samples[i]);
    CHECK(costs[chairs.yaws[i]] == 0);
    CHECK(cheapest(chairs.energies[i], costs) == chairs.yaws[i]);
  }
}

TEST_CASE("a shape that was not asked is turned by those that were") {
  Collection chairs("chairs", {"plain", "arms", "bench"}, 24);
  const AgreedYaws agreed(std::span(chairs.samples).first(16), std::span(chairs.energies).first(16));
  for (std::size_t i = 16; i < 24; ++i) CHECK(agreed.costs(chairs.samples[i])[chairs.yaws[i]] < 0.1);
  double against = 0;
  for (std::size_t i = 16; i < 24; ++i) against += agreed.costs(chairs.samples[i])[(chairs.yaws[i] + 2) % 4];
  CHECK(against > 8 * 0.3);
}

TEST_CASE("what looks the same turned is left to its own fit") {
  Collection lamps("lamps", {"pendant"}, 8);
  const AgreedYaws agreed(lamps.samples, lamps.energies);
  GenerateOptions options;
  options.styles = {"pendant"};
  const test::MadeShape other = test::make_shape("lamps", options, 20, 500);
  for (const double cost : agreed.costs(other.samples)) CHECK(cost < 0.1);
}

TEST_CASE("too few shapes agree on nothing") {
  const Collection chairs("chairs", {"plain"}, 3);
  const AgreedYaws agreed(chairs.samples, chairs.energies);
  CHECK(agreed.costs(chairs.samples[0]) == Energies{});
  CHECK(AgreedYaws({}, {}).costs(chairs.samples[0]) == Energies{});
  CHECK_THROWS_AS(AgreedYaws(chairs.samples, {}), PreconditionError);
}
