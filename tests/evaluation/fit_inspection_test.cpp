// What a fit is taken apart into is the whole of it.
#include "core/evaluation/fit_inspection.h"

#include <doctest/doctest.h>

#include <numeric>

#include "core/base/error.h"
#include "core/fitting/fit_template.h"
#include "tests/support/made_shapes.h"

using namespace archetype;

namespace {

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double sum_of(const FitInspection& inspection, double FitEnergy::*term) {
  double sum = 0;
  for (const FitEnergy& part : inspection.parts) sum += part.*term;
  return sum;
}

}  // namespace

TEST_CASE("the shares of samples and parts add up to the energy of the fit") {
  for (const std::string& family : families()) {
    const PartTemplate part_template = test::template_from(test::make_shape(family, {}, 0, 400));
    for (std::size_t i = 0; i < 3; ++i) {
      const test::MadeShape shape = test::make_shape(family, {}, i, 400);
      const auto fit = fit_template(part_template, shape.samples, {});
      REQUIRE(fit);
      const FitInspection inspection = inspect_fit(part_template, shape.samples, *fit, {});
      CAPTURE(family);
      for (const auto term :
           {&FitEnergy::shape_to_template, &FitEnergy::template_to_shape, &FitEnergy::features,
            &FitEnergy::deformation, &FitEnergy::smoothness, &FitEnergy::existence})
        CHECK(sum_of(inspection, term) == doctest::Approx(fit->energy.*term).epsilon(1e-9));
      CHECK(mean(inspection.shape_to_template) == doctest::Approx(fit->energy.shape_to_template));
      CHECK(mean(inspection.features) == doctest::Approx(fit->energy.features));
      CHECK(mean(inspection.smoothness) == doctest::Approx(fit->energy.smoothness));
      for (const auto& point : inspection.template_points) CHECK(fit->labels[point.sample] == point.part);
    }
  }
}

TEST_CASE("a fit of another shape or template is not taken apart") {
  const test::MadeShape shape = test::make_shape("chairs", {}, 0, 200);
  const PartTemplate part_template = test::template_from(shape);
  const auto fit = fit_template(part_template, shape.samples, {});
  CHECK_THROWS_AS(inspect_fit(part_template, test::make_shape("chairs", {}, 0, 100).samples, *fit, {}),
                  PreconditionError);
  CHECK_THROWS_AS(inspect_fit({}, shape.samples, *fit, {}), PreconditionError);
}
