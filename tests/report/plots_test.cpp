// The values of plots, against what can be counted by hand.
#include <doctest/doctest.h>

#include <cmath>
#include <numeric>

#include "core/base/error.h"
#include "core/report/plot_makers.h"
#include "tests/report/made_reports.h"

using namespace archetype;
using namespace archetype::test;

namespace {

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

Figure figure_of(const char* name, const PlotSources& sources) {
  return make_figure(*find_plot(name), sources);
}

}  // namespace

TEST_CASE("a histogram counts each value once, in its bin") {
  const std::vector<double> values{0, 0.1, 0.24, 0.25, 0.99, 1, -0.1, 1.1, NAN};
  const PlotSeries bars = histogram(values, 0, 1, 4);
  CHECK(bars.y == std::vector<double>{3, 1, 0, 2});
  CHECK(bars.x == std::vector<double>{0.125, 0.375, 0.625, 0.875});
  CHECK(bars.bar_width == 0.25);
}

TEST_CASE("plots of fits count members, outliers, parts and terms") {
  const FitTable fits = made_fits(30);
  PlotSources sources;
  sources.fits = &fits;
  const Plot members = figure_of("members", sources).panels.at(0);
  CHECK(members.categories == std::vector<std::string>{"chair", "chair 2"});
  CHECK(members.series[0].y[0] + members.series[1].y[0] == 20);
  CHECK(members.series[0].y[1] + members.series[1].y[1] == 10);
  CHECK(sum(members.series[1].y) == 6);

  const Plot presence = figure_of("part-presence", sources).panels.at(0);
  CHECK(presence.series[0].y[0] == 1);
  CHECK(presence.series[0].y[1] == 0.5);
  CHECK(presence.series[1].y == std::vector<double>{1, 0.5});

  const Plot terms = figure_of("energy-terms", sources).panels.at(0);
  CHECK(terms.categories.size() == 6);
  CHECK(terms.series[0].y[3] == doctest::Approx(0.05));
  CHECK(terms.series[0].y[0] == 0);

  double energies = 0;
  const Figure spread = figure_of("energies", sources);
  for (const Plot& panel : spread.panels) energies += sum(panel.series[0].y);
  CHECK(energies == 30);

  const Figure parameters = figure_of("part-parameters", sources);
  REQUIRE(parameters.panels.size() == 6);
  CHECK(sum(parameters.panels[1].series[0].y) == 20);
  // The Gaussian has as much area as the bars.
  const PlotSeries& curve = parameters.panels[1].series[1];
  const double area = sum(curve.y) * (curve.x[1] - curve.x[0]);
  CHECK(area == doctest::Approx(20 * parameters.panels[1].series[0].bar_width).epsilon(0.05));

  sources.part = 1;
  CHECK(sum(figure_of("part-parameters", sources).panels[1].series[0].y) == 10);
  sources.part = 2;
  CHECK_FALSE(has_what_it_needs(*find_plot("part-parameters"), sources));
  CHECK_THROWS_AS(figure_of("part-parameters", sources), PreconditionError);
}

TEST_CASE("plots of learning have a point at the start and one per round") {
  const LearningRecord record = made_record();
  const std::vector<SubsetMeasure> subsets{{8, 1, 0.5, 0.25}, {16, 2, 0.75, 0.5}};
  PlotSources sources;
  sources.learning = &record;
  sources.subsets = subsets;
  const PlotSeries energy = figure_of("learning-energy", sources).panels.at(0).series.at(0);
  CHECK(energy.x == std::vector<double>{0, 1, 2});
  CHECK(energy.y == std::vector<double>{0.9, 0.6, 0.5});
  CHECK(figure_of("learning-templates", sources).panels.at(0).series.at(0).y == std::vector<double>{1, 1, 2});
  const Figure sizes = figure_of("learning-sizes", sources);
  CHECK(sizes.panels.at(0).series.at(0).y == std::vector<double>{0.5, 0.75});
  CHECK(sizes.panels.at(1).series.at(0).y == std::vector<double>{1, 2});
}

TEST_CASE("learning by size shows the accuracy on other shapes first, where there was truth") {
  const std::vector<SubsetMeasure> subsets{{8, 1, 0.5, 0.25, 5, {0.6, 0.7, 0.8}},
                                           {16, 2, 0.75, 0.5, 5, {0.7, 0.8, std::nullopt}}};
  PlotSources sources;
  sources.subsets = subsets;
  const Figure figure = figure_of("learning-sizes", sources);
  REQUIRE(figure.panels.size() == 3);
  const Plot& accuracy = figure.panels[0];
  REQUIRE(accuracy.series.size() == 2);
  CHECK(accuracy.note == "Of 5 shapes that no subset holds");
  CHECK(accuracy.series[0].x == std::vector<double>{8});
  CHECK(accuracy.series[0].y == std::vector<double>{0.8});
  CHECK(accuracy.series[1].x == std::vector<double>{8, 16});
  CHECK(accuracy.series[1].y == std::vector<double>{0.6, 0.7});
}

TEST_CASE("learning from several starts shows each of them before and after") {
  std::vector<StartMeasure> starts(2);
  starts[0].initial.name = std::string("from a");
  starts[1].initial.name = std::string("from b");
  starts[0].energy_before = 2;
  starts[0].energy_after = 1;
  starts[1].energy_before = 3;
  starts[1].energy_after = 1.5;
  PlotSources sources;
  sources.starts = starts;
  const Figure without_truth = figure_of("learning-starts", sources);
  REQUIRE(without_truth.panels.size() == 1);
  CHECK(without_truth.panels[0].categories == std::vector<std::string>{"from a", "from b"});
  CHECK(without_truth.panels[0].series.at(0).y == std::vector<double>{2, 3});
  CHECK(without_truth.panels[0].series.at(1).y == std::vector<double>{1, 1.5});
  for (StartMeasure& start : starts) {
    start.before.best_labelling = 0.5;
    start.after.best_labelling = 0.9;
  }
  const Figure figure = figure_of("learning-starts", sources);
  REQUIRE(figure.panels.size() == 2);
  CHECK(figure.panels[0].series.at(1).y == std::vector<double>{0.9, 0.9});
}

TEST_CASE("plots of accuracy: by label, by part, and what was taken for what") {
  const LabellingEvaluation labelling = made_labelling();
  PlotSources sources;
  sources.labelling = &labelling;
  const Plot by_label = figure_of("accuracy-by-label", sources).panels.at(0);
  CHECK(by_label.categories == std::vector<std::string>{"chair", "back"});
  CHECK(by_label.series[0].y == std::vector<double>{0.75, 1});
  const Plot by_part = figure_of("accuracy-by-part", sources).panels.at(0);
  CHECK(by_part.series[0].y == std::vector<double>{1, 0.8});
  CHECK(by_part.series[0].notes[1] == "20 % is truly chair");
  const Figure confusion = figure_of("confusion", sources);
  REQUIRE(confusion.panels.size() == 1);  // the best assignment is the templates' own
  CHECK(confusion.panels[0].matrix->values == std::vector<double>{0.75, 0.25, 0, 1});
  const Figure by_shape = figure_of("accuracy-by-shape", sources);
  CHECK(sum(by_shape.panels[0].series[0].y) == 1);
  CHECK(by_shape.panels[1].series[0].y[0] == doctest::Approx(7.0 / 8));
}

TEST_CASE("plots of correspondence are the curves of the evaluation") {
  const LandmarkEvaluation landmarks = made_landmarks();
  PlotSources sources;
  sources.landmarks = &landmarks;
  const Plot plot = figure_of("correspondence", sources).panels.at(0);
  REQUIRE(plot.series.size() == 3);  // of diameter and diagonal, and as marked, which is another one here
  CHECK(plot.series[0].x.back() == 0.25);
  CHECK(plot.series[0].y.back() == 1);
  CHECK(plot.series[0].y[0] == 0.25);
  for (int i = 0; i <= ErrorCurve::steps; ++i)
    CHECK(plot.series[0].y[static_cast<std::size_t>(i)] == landmarks.all.by_diameter.within(i));
  const Plot by_landmark = figure_of("correspondence-by-landmark", sources).panels.at(0);
  CHECK(by_landmark.categories[0] == "chair tip");
  CHECK(by_landmark.series[0].y == std::vector<double>{1, 0.5});
}

TEST_CASE("a plot says what it lacks") {
  const PlotSources nothing;
  for (const PlotEntry& entry : plot_catalog()) {
    CHECK_FALSE(has_what_it_needs(entry, nothing));
    CHECK(find_plot(entry.name) == &entry);
    CHECK_THROWS_AS(make_figure(entry, nothing), PreconditionError);
  }
  CHECK(find_plot("none") == nullptr);
  CHECK(plot_catalog().size() >= 12);
}
