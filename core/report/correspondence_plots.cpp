// Figure 10: how many of the landmarks come to lie how near to where they should.
#include <algorithm>
#include <numeric>

#include "core/report/plot_makers.h"

namespace archetype {
namespace {

constexpr int near_step = 10;  // 0.05
constexpr int far_step = 20;   // 0.10

PlotSeries curve(const std::string& name, const ErrorCurve& errors, std::size_t colour, bool dashed) {
  PlotSeries series{.name = name, .colour = series_colour(colour), .dashed = dashed};
  for (int i = 0; i <= ErrorCurve::steps; ++i) {
    series.x.push_back(i * ErrorCurve::step);
    series.y.push_back(errors.within(i));
  }
  return series;
}

std::string landmark_name(const LandmarkEvaluation& evaluation, std::size_t i) {
  return i < evaluation.landmark_names.size() ? evaluation.landmark_names[i]
                                              : "landmark " + std::to_string(i);
}

}  // namespace

Figure plot_correspondence(const PlotSources& sources) {
  const LandmarkEvaluation& evaluation = *sources.landmarks;
  Plot plot;
  plot.note = std::to_string(evaluation.all.by_diameter.count()) + " landmarks carried between " +
              std::to_string(evaluation.shapes.size()) + " shapes; " + std::to_string(evaluation.unmapped) +
              " found no counterpart";
  plot.x = {.label = "error, as a share of the shape's size",
            .low = 0,
            .high = ErrorCurve::steps * ErrorCurve::step};
  plot.y = {.label = "share of the landmarks that are as near", .low = 0, .high = 1, .percent = true};
  plot.series.push_back(curve("all pairs, of diameter", evaluation.all.by_diameter, 1, false));
  plot.series.push_back(curve("all pairs, of diagonal", evaluation.all.by_diagonal, 1, true));
  if (evaluation.same_template.by_diameter.count() > 0 &&
      evaluation.same_template.by_diameter.count() < evaluation.all.by_diameter.count()) {
    plot.series.push_back(
        curve("same template, of diameter", evaluation.same_template.by_diameter, 0, false));
    plot.series.push_back(curve("same template, of diagonal", evaluation.same_template.by_diagonal, 0, true));
  }
  if (!(evaluation.as_marked == evaluation.all))
    plot.series.push_back(curve("as marked, turns not made good", evaluation.as_marked.by_diameter, 7, true));
  return {.panels = {std::move(plot)}};
}

Figure plot_correspondence_by_landmark(const PlotSources& sources) {
  const LandmarkEvaluation& evaluation = *sources.landmarks;
  std::vector<std::size_t> order(evaluation.landmarks.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::stable_sort(order, std::greater<>(), [&](std::size_t i) {
    return evaluation.landmarks[i].by_diameter.within(near_step);
  });
  Plot plot;
  plot.note = "Share of the landmarks that come as near, best first";
  plot.y = {.low = 0, .high = 1, .percent = true};
  PlotSeries near{
      .name = "within 0.05 of the diameter", .kind = SeriesKind::bars, .colour = series_colour(0)};
  PlotSeries far{.name = "within 0.10", .kind = SeriesKind::bars, .colour = series_colour(4)};
  for (const std::size_t i : order) {
    const ErrorCurve& errors = evaluation.landmarks[i].by_diameter;
    if (errors.count() == 0) continue;
    for (PlotSeries* series : {&near, &far}) series->x.push_back(static_cast<double>(plot.categories.size()));
    plot.categories.push_back(landmark_name(evaluation, i));
    near.y.push_back(errors.within(near_step));
    far.y.push_back(errors.within(far_step));
    near.notes.push_back(std::to_string(errors.count()) + " pairs");
  }
  plot.series = {std::move(near), std::move(far)};
  return {.panels = {std::move(plot)}};
}

}  // namespace archetype
