#include "core/fitting/template_choice.h"

#include <doctest/doctest.h>

#include "core/fitting/fit_template.h"
#include "tests/support/made_shapes.h"
#include "tests/support/small_collection.h"

using namespace archetype;
using namespace archetype::test;

namespace {

PartTemplate with_spreads(PartTemplate part_template, double factor) {
  for (TemplatePart& part : part_template.parts) {
    part.position.stddev *= factor;
    part.scale.stddev *= factor;
  }
  return part_template;
}

}  // namespace

TEST_CASE("narrower spreads are worth less and less, and nothing where no fit could tell them") {
  std::vector<ShapeSamples> shapes;
  add_chairs(shapes, "plain", 1, 500);
  PartTemplate part_template = chair_template();
  ShapeFit fit = fit_template(part_template, shapes[0], {}).value();
  // The boxes lie where they are expected, so that only the spreads count.
  for (std::size_t k = 0; k < fit.parts.size(); ++k) {
    part_template.parts[k].position.mean = fit.parts[k].box.centre;
    part_template.parts[k].scale.mean = fit.parts[k].box.half_extent;
    part_template.parts[k].orientation = fit.parts[k].box.orientation;
  }
  const auto energy = [&](double factor) {
    return choice_energy(fit, with_spreads(part_template, factor), shapes[0], {});
  };
  CHECK(energy(0.5) < energy(1));
  CHECK(energy(1) - energy(0.5) > energy(0.05) - energy(0.025));
  CHECK(energy(0.001) - energy(0.0001) < 1e-3);
}
