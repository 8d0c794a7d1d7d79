#include "core/fitting/template_choice.h"

#include <doctest/doctest.h>

#include <cmath>

#include "core/fitting/fit_template.h"
#include "tests/support/made_shapes.h"

using namespace archetype;

TEST_CASE("a template gains by what it expects exactly, of the parts that a shape has") {
  const test::MadeShape shape = test::make_shape("tables", {}, 0, 300);
  PartTemplate part_template = test::template_from(shape);
  ShapeFit fit = *fit_template(part_template, shape.samples, {});
  REQUIRE(fit.parts[0].present);
  for (std::size_t k = 0; k < fit.parts.size(); ++k) fit.parts[k].box = part_template.parts[k].mean_box();
  const auto choice = [&](double stddev) {
    part_template.parts[0].position.stddev = part_template.parts[0].scale.stddev = Vec3::Constant(stddev);
    return choice_energy(fit, part_template, {});
  };
  // Six Gaussians at their means, each half as wide.
  CHECK(choice(0.4) - choice(0.2) == doctest::Approx(6 * 2 * FitOptions{}.alpha * std::log(2.0)));
  fit.parts[0].present = false;
  CHECK(choice(0.4) == choice(0.2));
}
