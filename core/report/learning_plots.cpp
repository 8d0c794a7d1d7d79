// Plots of how templates were learned.
#include "core/report/plot_makers.h"

namespace archetype {
namespace {

std::string count_of(std::size_t count, const std::string& thing) {
  return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

std::string judged_by(const LearningRecord& record) {
  return "Judged by " + count_of(record.judging.size(), "shape") +
         (record.settled ? "; the last round kept nothing new" : "; not settled");
}

}  // namespace

Figure plot_learning_energy(const PlotSources& sources) {
  const LearningRecord& record = *sources.learning;
  Plot plot;
  plot.note = judged_by(record);
  plot.x = {.label = "round", .low = 0, .whole = true};
  plot.y = {.label = "mean energy of the judging shapes, with what the templates cost"};
  PlotSeries energy{.kind = SeriesKind::line_and_dots, .colour = series_colour(0)};
  energy.x.push_back(0);
  energy.y.push_back(record.steps.front().energy_before);
  energy.notes.push_back(count_of(record.start.size(), "template"));
  for (const LearningStep& step : record.steps) {
    energy.x.push_back(step.iteration);
    energy.y.push_back(step.energy);
    energy.notes.push_back(count_of(step.templates.size(), "template"));
  }
  plot.series.push_back(std::move(energy));
  return {.panels = {std::move(plot)}};
}

Figure plot_learning_templates(const PlotSources& sources) {
  const LearningRecord& record = *sources.learning;
  Plot plot;
  plot.note = judged_by(record);
  plot.x = {.label = "round", .low = 0, .whole = true};
  plot.y = {.label = "templates", .low = 0, .whole = true};
  PlotSeries templates{.kind = SeriesKind::line_and_dots, .colour = series_colour(1)};
  templates.x.push_back(0);
  templates.y.push_back(static_cast<double>(record.start.size()));
  for (const LearningStep& step : record.steps) {
    templates.x.push_back(step.iteration);
    templates.y.push_back(static_cast<double>(step.templates.size()));
  }
  plot.series.push_back(std::move(templates));
  return {.panels = {std::move(plot)}};
}

Figure plot_learning_sizes(const PlotSources& sources) {
  Plot time;
  time.title = "Time";
  time.note = "Random subsets of this collection, the smaller ones within the larger ones";
  time.x = {.label = "shapes", .low = 0};
  time.y = {.label = "seconds", .low = 0};
  PlotSeries learning{.name = "learning", .kind = SeriesKind::line_and_dots, .colour = series_colour(0)};
  PlotSeries fitting{.name = "fitting and labelling all of them",
                     .kind = SeriesKind::line_and_dots,
                     .colour = series_colour(6),
                     .dashed = true};
  Plot templates;
  templates.title = "Templates";
  templates.x = {.label = "shapes", .low = 0};
  templates.y = {.label = "templates", .low = 0, .whole = true};
  PlotSeries count{.kind = SeriesKind::line_and_dots, .colour = series_colour(1)};
  for (const SubsetMeasure& measure : sources.subsets) {
    for (PlotSeries* series : {&learning, &fitting, &count})
      series->x.push_back(static_cast<double>(measure.shapes));
    learning.y.push_back(measure.learning_seconds);
    fitting.y.push_back(measure.fitting_seconds);
    count.y.push_back(static_cast<double>(measure.templates));
    learning.notes.push_back(count_of(measure.templates, "template"));
  }
  time.series = {std::move(learning), std::move(fitting)};
  templates.series.push_back(std::move(count));
  return {.panels = {std::move(time), std::move(templates)}, .columns = 2};
}

}  // namespace archetype
