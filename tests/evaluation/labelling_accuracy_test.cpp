#include "core/evaluation/labelling_accuracy.h"

#include <doctest/doctest.h>

#include "core/base/error.h"

using namespace archetype;

namespace {

ShapeOverlap shape(const std::string& name, const std::vector<int>& parts, const std::vector<int>& truth,
                   const std::vector<double>& areas) {
  return {name, measure_overlap(parts, truth, areas)};
}

}  // namespace

TEST_CASE("accuracies by area and by number, own and best, for each shape, on average and in all") {
  // Parts 0 and 1 are called 5 and 6; the truth calls them 6 (most of it) and 6.
  const std::vector<int> own{5, 6};
  const std::vector<ShapeOverlap> shapes{
      shape("first", {0, 0, 1, -1}, {5, 6, 6, 6}, {1, 3, 4, 2}),
      shape("second", {0, 1}, {6, 6}, {1, 1}),
  };
  const LabellingReport report = measure_labelling(shapes, own);
  REQUIRE(report.shapes.size() == 2);
  CHECK(report.shapes[0].name == "first");
  CHECK(report.shapes[0].own.by_area == doctest::Approx(0.5));
  CHECK(report.shapes[0].own.by_count == doctest::Approx(0.5));
  CHECK(report.best_labels == std::vector<int>{6, 6});
  CHECK(report.shapes[0].best.by_area == doctest::Approx(0.7));
  CHECK(report.shapes[0].best.by_count == doctest::Approx(0.5));
  CHECK(report.shapes[1].own.by_area == doctest::Approx(0.5));
  CHECK(report.shapes[1].best.by_area == doctest::Approx(1));
  CHECK(report.mean.best.by_area == doctest::Approx(0.85));
  CHECK(report.mean.own.by_count == doctest::Approx(0.5));
  CHECK(report.total.own.by_area == doctest::Approx(6.0 / 12));
  CHECK(report.total.best.by_area == doctest::Approx(9.0 / 12));
  CHECK(report.total.best.by_count == doctest::Approx(4.0 / 6));
  CHECK(report.own_confusion.at({5, 5}) == ElementShare{1, 1});
  CHECK(report.own_confusion.at({5, 6}) == ElementShare{4, 2});
  CHECK(report.own_confusion.at({-1, 6}) == ElementShare{2, 1});
  CHECK(report.best_confusion.at({6, 6}) == ElementShare{9, 4});
}

TEST_CASE("elements without truth are left out, elements in no part are wrong") {
  const LabellingReport report = measure_labelling({{shape("s", {0, -1, 0}, {1, 1, -1}, {1, 1, 7})}}, {{1}});
  CHECK(report.total.own.by_area == doctest::Approx(0.5));
  CHECK(report.total.own.by_count == doctest::Approx(0.5));
}

TEST_CASE("a part whose own label is negative is wrong, and one without any surface has no best label") {
  const LabellingReport report = measure_labelling({{shape("s", {0}, {3}, {1})}}, {{-1, 3}});
  CHECK(report.total.own.by_area == 0);
  CHECK(report.best_labels == std::vector<int>{3, -1});
  CHECK(report.total.best.by_area == 1);
}

TEST_CASE("nothing to measure is no division by nothing") {
  CHECK(measure_labelling({}, {{1}}).mean.own.by_area == 0);
  CHECK(measure_labelling({{shape("flat", {0}, {1}, {0})}}, {{1}}).shapes[0].own.by_area == 1);
  CHECK_THROWS_AS(measure_overlap({{1, 2}}, {{1}}, {{1}}), PreconditionError);
}
