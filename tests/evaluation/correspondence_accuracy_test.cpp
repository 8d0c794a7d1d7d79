#include "core/evaluation/correspondence_accuracy.h"

#include <doctest/doctest.h>

#include <limits>

#include "core/base/error.h"

using namespace archetype;

TEST_CASE("a curve is the share of errors within each threshold") {
  ErrorCurve curve;
  CHECK(curve.within(0) == 1);
  curve.add(0);
  curve.add(0.05);
  curve.add(0.0501);
  curve.add(0.26);
  curve.add(std::numeric_limits<double>::infinity());
  CHECK(curve.count() == 5);
  CHECK(curve.within(0) == doctest::Approx(0.2));
  CHECK(curve.within(9) == doctest::Approx(0.2));
  CHECK(curve.within(10) == doctest::Approx(0.4));
  CHECK(curve.within(11) == doctest::Approx(0.6));
  CHECK(curve.within(ErrorCurve::steps) == doctest::Approx(0.6));
  // 0.15 / 0.005 is a little more than 30 in binary.
  ErrorCurve exact;
  exact.add(0.15);
  CHECK(exact.within(29) == 0);
  CHECK(exact.within(30) == 1);
  ErrorCurve both = curve;
  both += exact;
  CHECK(both.count() == 6);
  CHECK(both.within(30) == doctest::Approx(4.0 / 6));
  CHECK_THROWS_AS(curve.add(-1), PreconditionError);
  CHECK_THROWS_AS(curve.add(std::numeric_limits<double>::quiet_NaN()), PreconditionError);
}
