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

// On shapes that no subset holds; no series where there was no ground truth.
Plot accuracy_by_size(std::span<const SubsetMeasure> measures) {
  Plot plot;
  plot.title = "Accuracy on other shapes";
  plot.x = {.label = "shapes", .low = 0};
  plot.y = {.label = "share", .low = 0, .high = 1, .percent = true};
  PlotSeries correspondence{.name = "landmarks within 0.05 of the diameter",
                            .kind = SeriesKind::line_and_dots,
                            .colour = series_colour(1)};
  PlotSeries labelling{.name = "area with its true label",
                       .kind = SeriesKind::line_and_dots,
                       .colour = series_colour(0),
                       .dashed = true};
  for (const SubsetMeasure& measure : measures) {
    if (measure.judging > 0) plot.note = "Of " + count_of(measure.judging, "shape") + " that no subset holds";
    const auto add = [&](PlotSeries& series, const std::optional<double>& share) {
      if (!share) return;
      series.x.push_back(static_cast<double>(measure.shapes));
      series.y.push_back(*share);
    };
    add(correspondence, measure.accuracy.correspondence);
    add(labelling, measure.accuracy.labelling);
  }
  for (PlotSeries* series : {&correspondence, &labelling})
    if (!series->x.empty()) plot.series.push_back(std::move(*series));
  return plot;
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
  time.note = "Random subsets, the smaller ones within the larger ones";
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
  Figure figure{.panels = {std::move(time), std::move(templates)}, .columns = 2};
  if (Plot accuracy = accuracy_by_size(sources.subsets); !accuracy.series.empty())
    figure.panels.insert(figure.panels.begin(), std::move(accuracy));
  return figure;
}

Figure plot_learning_starts(const PlotSources& sources) {
  Plot energy;
  energy.title = "Mean energy";
  energy.note = "Of the fits to all shapes, existence of parts included; less is better";
  Plot labelling;
  labelling.title = "Labels right, by area";
  labelling.note = "With the best assignment of labels to the parts";
  labelling.y = {.low = 0, .high = 1, .percent = true};
  const PlotSeries before{.name = "before learning", .kind = SeriesKind::bars, .colour = series_colour(4)};
  const PlotSeries after{.name = "after learning", .kind = SeriesKind::bars, .colour = series_colour(0)};
  energy.series = {before, after};
  labelling.series = {before, after};
  bool labelled = false;
  for (const StartMeasure& measure : sources.starts) {
    const auto at = static_cast<double>(energy.categories.size());
    for (Plot* plot : {&energy, &labelling}) {
      plot->categories.push_back(measure.initial.name);
      for (PlotSeries& series : plot->series) series.x.push_back(at);
    }
    const std::string parts = count_of(measure.initial.parts.size(), "part");
    const std::string learned = count_of(measure.learned.size(), "template");
    energy.series[0].y.push_back(measure.energy_before);
    energy.series[1].y.push_back(measure.energy_after);
    labelling.series[0].y.push_back(measure.before.best_labelling.value_or(0));
    labelling.series[1].y.push_back(measure.after.best_labelling.value_or(0));
    for (Plot* plot : {&energy, &labelling}) {
      plot->series[0].notes.push_back(parts);
      plot->series[1].notes.push_back(learned);
    }
    labelled = labelled || measure.after.best_labelling;
  }
  Figure figure{.panels = {std::move(energy)}, .columns = 2};
  if (labelled) figure.panels.insert(figure.panels.begin(), std::move(labelling));
  return figure;
}

}  // namespace archetype
