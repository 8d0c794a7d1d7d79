// Figure 3 and table 1: how well the labels agree with ground truth, and what is taken for what.
#include <algorithm>
#include <set>

#include "core/model/part_names.h"
#include "core/report/plot_makers.h"

namespace archetype {
namespace {

using Confusion = std::map<std::pair<int, int>, ElementShare>;

constexpr const char* no_part = "no part";

// By the label files, or else by the parts that have the label.
std::string label_name(const LabellingEvaluation& evaluation, int label) {
  if (label < 0) return no_part;
  if (static_cast<std::size_t>(label) < evaluation.label_names.size())
    return evaluation.label_names[static_cast<std::size_t>(label)];
  std::vector<std::string> parts;
  for (const EvaluatedPart& part : evaluation.parts)
    if (part.label == label) parts.push_back(part.part);
  return (parts.empty() ? "label" : common_part_name(parts)) + " (" + std::to_string(label) + ")";
}

std::set<int> true_labels(const LabellingReport& report) {
  std::set<int> labels;
  for (const auto& [pair, share] : report.own_confusion) labels.insert(pair.second);
  return labels;
}

// Of the area with a true label, what is predicted right.
double found_share(const Confusion& confusion, int label) {
  double right = 0;
  double all = 0;
  for (const auto& [pair, share] : confusion) {
    if (pair.second != label) continue;
    all += share.area;
    if (pair.first == label) right += share.area;
  }
  return all > 0 ? right / all : 0;
}

std::string mean_text(const LabellingReport& report) {
  char text[160];
  std::snprintf(text, sizeof text,
                "%zu shapes; mean by area %.1f %%, by faces %.1f %%; best assignment %.1f %%",
                report.shapes.size(), 100 * report.mean.own.by_area, 100 * report.mean.own.by_count,
                100 * report.mean.best.by_area);
  return text;
}

PlotMatrix confusion_matrix(const LabellingEvaluation& evaluation, const Confusion& confusion) {
  PlotMatrix matrix{.row_label = "true label",
                    .column_label = "Columns: label found",
                    .rows = {},
                    .columns = {},
                    .values = {}};
  const std::set<int> truths = true_labels(evaluation.report);
  std::set<int> predictions = truths;
  for (const auto& [pair, share] : confusion) predictions.insert(pair.first);
  // "No part" last.
  std::vector<int> columns(predictions.lower_bound(0), predictions.end());
  if (predictions.contains(-1)) columns.push_back(-1);
  for (const int label : columns) matrix.columns.push_back(label_name(evaluation, label));
  for (const int truth : truths) {
    matrix.rows.push_back(label_name(evaluation, truth));
    double all = 0;
    for (const auto& [pair, share] : confusion)
      if (pair.second == truth) all += share.area;
    for (const int label : columns) {
      const auto found = confusion.find({label, truth});
      matrix.values.push_back(found != confusion.end() && all > 0 ? found->second.area / all : 0);
    }
  }
  return matrix;
}

}  // namespace

Figure plot_accuracy_by_label(const PlotSources& sources) {
  const LabellingEvaluation& evaluation = *sources.labelling;
  Plot plot;
  plot.note = mean_text(evaluation.report);
  plot.y = {
      .label = "share of the area with this true label that is found", .low = 0, .high = 1, .percent = true};
  PlotSeries own{.name = "labels of the templates", .kind = SeriesKind::bars, .colour = series_colour(0)};
  PlotSeries best{.name = "best assignment of parts", .kind = SeriesKind::bars, .colour = series_colour(4)};
  for (const int label : true_labels(evaluation.report)) {
    for (PlotSeries* series : {&own, &best}) series->x.push_back(static_cast<double>(plot.categories.size()));
    plot.categories.push_back(label_name(evaluation, label));
    own.y.push_back(found_share(evaluation.report.own_confusion, label));
    best.y.push_back(found_share(evaluation.report.best_confusion, label));
  }
  plot.series = {std::move(own), std::move(best)};
  return {.panels = {std::move(plot)}};
}

Figure plot_accuracy_by_part(const PlotSources& sources) {
  const LabellingEvaluation& evaluation = *sources.labelling;
  Plot plot;
  plot.note = "Of the area that lies in a part, what truly has its label";
  plot.y = {.label = "share of the part's area", .low = 0, .high = 1, .percent = true};
  PlotSeries right{.kind = SeriesKind::bars, .colour = series_colour(2)};
  std::set<std::string> names;
  for (std::size_t p = 0; p < evaluation.parts.size(); ++p) {
    const EvaluatedPart& part = evaluation.parts[p];
    double all = 0;
    double correct = 0;
    std::pair<double, int> most{0, -1};
    for (const auto& [pair, share] : evaluation.report.part_confusion) {
      if (pair.first != static_cast<int>(p)) continue;
      all += share.area;
      if (pair.second == part.label)
        correct += share.area;
      else
        most = std::max(most, {share.area, pair.second});
    }
    if (!(all > 0)) continue;  // of a template that is history
    std::string note;
    if (most.first > 0)
      note = std::to_string(std::lround(100 * most.first / all)) + " % is truly " +
             label_name(evaluation, most.second);
    right.x.push_back(static_cast<double>(plot.categories.size()));
    right.y.push_back(correct / all);
    right.notes.push_back(note);
    plot.categories.push_back(part.part_template + " / " + part.part);
    plot.parts.push_back({part.part_template, part.part});
  }
  plot.series.push_back(std::move(right));
  return {.panels = {std::move(plot)}};
}

Figure plot_accuracy_by_shape(const PlotSources& sources) {
  const LabellingReport& report = sources.labelling->report;
  const std::vector<ShapeId>& ids = sources.labelling->shapes;
  const bool known = ids.size() == report.shapes.size();
  std::vector<double> values;
  for (const ShapeAccuracy& shape : report.shapes) values.push_back(shape.own.by_area);
  Plot spread;
  spread.title = "All shapes";
  spread.note = mean_text(report);
  spread.x = {.label = "accuracy by area", .low = 0, .high = 1, .percent = true};
  spread.y = {.label = "shapes", .whole = true};
  PlotSeries bars = histogram(values, 0, 1, 20, known ? std::span(ids) : std::span<const ShapeId>());
  bars.colour = series_colour(0);
  spread.series.push_back(std::move(bars));

  Plot worst;
  worst.title = "The worst";
  worst.y = {.label = "accuracy by area", .low = 0, .high = 1, .percent = true};
  std::vector<const ShapeAccuracy*> shapes;
  for (const ShapeAccuracy& shape : report.shapes) shapes.push_back(&shape);
  std::ranges::stable_sort(shapes, {}, [](const ShapeAccuracy* shape) { return shape->own.by_area; });
  shapes.resize(std::min<std::size_t>(shapes.size(), 20));
  PlotSeries own{.kind = SeriesKind::bars, .colour = series_colour(1)};
  for (const ShapeAccuracy* shape : shapes) {
    own.x.push_back(static_cast<double>(worst.categories.size()));
    own.y.push_back(shape->own.by_area);
    worst.categories.push_back(shape->name);
    if (known) own.shapes.push_back({ids[static_cast<std::size_t>(shape - report.shapes.data())]});
  }
  worst.series.push_back(std::move(own));
  return {.panels = {std::move(spread), std::move(worst)}, .columns = 2};
}

Figure plot_confusion(const PlotSources& sources) {
  const LabellingEvaluation& evaluation = *sources.labelling;
  Figure figure;
  figure.columns = 2;
  for (const bool own : {true, false}) {
    Plot plot;
    plot.title = own ? "Labels of the templates" : "Best assignment of parts to labels";
    plot.note = "Share of the area of each true label";
    plot.matrix = confusion_matrix(evaluation,
                                   own ? evaluation.report.own_confusion : evaluation.report.best_confusion);
    figure.panels.push_back(std::move(plot));
  }
  if (figure.panels[0].matrix->values == figure.panels[1].matrix->values) figure.panels.pop_back();
  return figure;
}

}  // namespace archetype
