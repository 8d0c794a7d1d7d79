// Plots of what the fits of a collection say.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/report/plot_makers.h"

namespace archetype {
namespace {

constexpr std::size_t bins = 24;

std::string count_of(std::size_t count, const std::string& thing) {
  return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

std::vector<const FitTableRow*> members_of(const FitTable& table, std::size_t part_template) {
  std::vector<const FitTableRow*> members;
  for (const FitTableRow& row : table.rows)
    if (row.part_template == part_template) members.push_back(&row);
  return members;
}

// From the least to what all but a hundredth are below: one broken fit must not squeeze the others.
std::pair<double, double> range_of(std::vector<double> values) {
  std::erase_if(values, [](double value) { return !std::isfinite(value) || std::abs(value) > 1e100; });
  if (values.empty()) return {0, 1};
  std::ranges::sort(values);
  const double low = values[values.size() / 200];
  const double high = values[values.size() - 1 - values.size() / 100];
  const double room = std::max(0.02 * (high - low), 1e-6 * std::max(1.0, std::abs(high)));
  return {low - room, high + room};
}

std::string share_text(double share) {
  return std::to_string(std::lround(100 * share)) + " %";
}

struct Term {
  const char* name;
  double (*value)(const FitEnergy&);
};
constexpr std::array terms{
    Term{"shape to template", [](const FitEnergy& e) { return e.shape_to_template; }},
    Term{"template to shape", [](const FitEnergy& e) { return e.template_to_shape; }},
    Term{"features", [](const FitEnergy& e) { return e.features; }},
    Term{"deformation", [](const FitEnergy& e) { return e.deformation; }},
    Term{"smoothness", [](const FitEnergy& e) { return e.smoothness; }},
    Term{"existence", [](const FitEnergy& e) { return e.existence; }},
};

// The normal distribution as counts that bins so wide would hold of so many values.
PlotSeries gaussian(double mean, double stddev, double low, double high, double scale) {
  PlotSeries curve;
  curve.name = "template";
  curve.colour = {60, 60, 60};
  constexpr int steps = 80;
  if (!(stddev > 0)) return curve;
  for (int i = 0; i <= steps; ++i) {
    const double x = low + (high - low) * i / steps;
    const double z = (x - mean) / stddev;
    curve.x.push_back(x);
    curve.y.push_back(scale * std::exp(-z * z / 2) / (stddev * std::sqrt(2 * std::numbers::pi)));
  }
  return curve;
}

struct Values {
  std::vector<double> values;
  std::vector<ShapeId> shapes;  // of each
  void add(double value, const FitTableRow& row) {
    values.push_back(value);
    shapes.push_back(row.summary.shape);
  }
};

std::vector<ShapeId> shapes_of(const std::vector<const FitTableRow*>& rows) {
  std::vector<ShapeId> shapes;
  for (const FitTableRow* row : rows) shapes.push_back(row->summary.shape);
  return shapes;
}

Plot parameter_plot(const std::string& title, const Values& of, double mean, double stddev,
                    const Rgb& colour) {
  const std::vector<double>& values = of.values;
  Plot plot;
  plot.title = title;
  plot.y = {.label = "shapes"};
  auto [low, high] = range_of(values);
  if (std::isfinite(mean) && std::isfinite(stddev)) {
    low = std::min(low, mean - 2.5 * stddev);
    high = std::max(high, mean + 2.5 * stddev);
  }
  PlotSeries bars = histogram(values, low, high, bins, of.shapes);
  bars.name = "fits";
  bars.colour = colour;
  plot.x.low = low;
  plot.x.high = high;
  const double per_bin = static_cast<double>(values.size()) * (high - low) / bins;
  plot.series = {std::move(bars), gaussian(mean, stddev, low, high, per_bin)};
  return plot;
}

}  // namespace

PlotSeries histogram(std::span<const double> values, double low, double high, std::size_t count,
                     std::span<const ShapeId> shapes) {
  PlotSeries series;
  series.kind = SeriesKind::bars;
  series.bar_width = (high - low) / static_cast<double>(count);
  for (std::size_t i = 0; i < count; ++i)
    series.x.push_back(low + series.bar_width * (static_cast<double>(i) + 0.5));
  series.y.assign(count, 0);
  if (!shapes.empty()) series.shapes.resize(count);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double value = values[i];
    if (!(value >= low && value <= high)) continue;
    const auto bin = std::min(static_cast<std::size_t>((value - low) / series.bar_width), count - 1);
    ++series.y[bin];
    if (!shapes.empty()) series.shapes[bin].push_back(shapes[i]);
  }
  return series;
}

Figure plot_members(const PlotSources& sources) {
  const FitTable& table = *sources.fits;
  Plot plot;
  plot.y = {.label = "shapes", .whole = true};
  PlotSeries fitted{.name = "fitted", .kind = SeriesKind::bars, .colour = series_colour(0)};
  PlotSeries outliers{.name = "outliers", .kind = SeriesKind::bars, .colour = series_colour(1)};
  for (std::size_t t = 0; t < table.templates.size(); ++t) {
    const auto members = members_of(table, t);
    std::vector<ShapeId>& found = fitted.shapes.emplace_back();
    std::vector<ShapeId>& lost = outliers.shapes.emplace_back();
    for (const FitTableRow* row : members)
      (row->summary.status == FitStatus::outlier ? lost : found).push_back(row->summary.shape);
    plot.categories.push_back(table.templates[t].part_template.name);
    for (PlotSeries* series : {&fitted, &outliers}) series->x.push_back(static_cast<double>(t));
    fitted.y.push_back(static_cast<double>(found.size()));
    outliers.y.push_back(static_cast<double>(lost.size()));
    fitted.notes.push_back(
        share_text(static_cast<double>(members.size()) / static_cast<double>(table.rows.size())) +
        " of all shapes take it");
  }
  plot.note = count_of(table.rows.size(), "shape");
  plot.series = {std::move(fitted), std::move(outliers)};
  return {.panels = {std::move(plot)}};
}

Figure plot_energies(const PlotSources& sources) {
  const FitTable& table = *sources.fits;
  std::vector<double> all;
  for (const FitTableRow& row : table.rows) all.push_back(row.summary.energy.total());
  const auto [low, high] = range_of(all);
  Figure figure;
  figure.columns = 2;
  for (std::size_t t = 0; t < table.templates.size(); ++t) {
    const auto members = members_of(table, t);
    if (members.empty()) continue;
    std::vector<double> values;
    for (const FitTableRow* row : members) values.push_back(row->summary.energy.total());
    Plot plot;
    plot.title = table.templates[t].part_template.name;
    double sum = 0;
    for (const double value : values) sum += value;
    char note[96];
    std::snprintf(note, sizeof note, "%zu shapes, mean energy %.4f", values.size(),
                  sum / static_cast<double>(values.size()));
    plot.note = note;
    plot.x = {.label = "energy", .low = low, .high = high};
    plot.y = {.label = "shapes", .whole = true};
    PlotSeries bars = histogram(values, low, high, bins, shapes_of(members));
    bars.colour = series_colour(t);
    plot.series.push_back(std::move(bars));
    figure.panels.push_back(std::move(plot));
  }
  return figure;
}

Figure plot_energy_terms(const PlotSources& sources) {
  const FitTable& table = *sources.fits;
  Plot plot;
  plot.note = "Mean over the shapes of each template, weights applied";
  plot.y = {.label = "energy"};
  for (const Term& term : terms) plot.categories.emplace_back(term.name);
  for (std::size_t t = 0; t < table.templates.size(); ++t) {
    const auto members = members_of(table, t);
    if (members.empty()) continue;
    PlotSeries series{
        .name = table.templates[t].part_template.name, .kind = SeriesKind::bars, .colour = series_colour(t)};
    for (std::size_t i = 0; i < terms.size(); ++i) {
      double sum = 0;
      for (const FitTableRow* row : members) sum += terms[i].value(row->summary.energy);
      series.x.push_back(static_cast<double>(i));
      series.y.push_back(sum / static_cast<double>(members.size()));
      series.shapes.push_back(shapes_of(members));
    }
    plot.series.push_back(std::move(series));
  }
  return {.panels = {std::move(plot)}};
}

Figure plot_part_presence(const PlotSources& sources) {
  const FitTable& table = *sources.fits;
  const PartTemplate& part_template = table.templates[sources.part_template].part_template;
  const auto members = members_of(table, sources.part_template);
  Plot plot;
  plot.note = count_of(members.size(), "shape") + " of " + part_template.name;
  plot.y = {.label = "share of the shapes", .low = 0, .high = 1, .percent = true};
  PlotSeries found{.name = "found", .kind = SeriesKind::bars, .colour = series_colour(0)};
  PlotSeries learned{
      .name = "existence in the template", .kind = SeriesKind::bars, .colour = series_colour(4)};
  for (std::size_t p = 0; p < part_template.parts.size(); ++p) {
    plot.categories.push_back(part_template.parts[p].name);
    plot.parts.push_back({part_template.name, part_template.parts[p].name});
    std::vector<ShapeId>& having = found.shapes.emplace_back();
    double share = 0;
    for (const FitTableRow* row : members) {
      const PartValues& values = table.parts_of(*row)[p];
      if (!values.present) continue;
      having.push_back(row->summary.shape);
      share += values.share;
    }
    const std::size_t present = having.size();
    for (PlotSeries* series : {&found, &learned}) series->x.push_back(static_cast<double>(p));
    found.y.push_back(members.empty() ? 0
                                      : static_cast<double>(present) / static_cast<double>(members.size()));
    found.notes.push_back(
        count_of(present, "shape") +
        (present > 0 ? ", " + share_text(share / static_cast<double>(present)) + " of the surface on average"
                     : ""));
    learned.y.push_back(part_template.parts[p].must_exist ? 1 : part_template.parts[p].existence);
  }
  plot.series = {std::move(found), std::move(learned)};
  return {.title = "Shapes that have each part: " + part_template.name, .panels = {std::move(plot)}};
}

Figure plot_part_parameters(const PlotSources& sources) {
  const FitTable& table = *sources.fits;
  const PartTemplate& part_template = table.templates[sources.part_template].part_template;
  const TemplatePart& part = part_template.parts[sources.part];
  const Rgb colour = part_colour(part_template, static_cast<int>(sources.part));
  Figure figure;
  figure.title = "Positions and sizes: " + part_template.name + ", " + part.name;
  figure.columns = 3;
  constexpr std::array positions{"Centre, left to right (x)", "Centre, height (y)",
                                 "Centre, back to front (z)"};
  constexpr std::array sizes{"Half width (x)", "Half height (y)", "Half depth (z)"};
  for (const bool is_size : {false, true}) {
    for (int axis = 0; axis < 3; ++axis) {
      Values values;
      for (const FitTableRow* row : members_of(table, sources.part_template)) {
        const PartValues& found = table.parts_of(*row)[sources.part];
        if (found.present) values.add(is_size ? found.box.half_extent[axis] : found.box.centre[axis], *row);
      }
      const Gaussian3& learned = is_size ? part.scale : part.position;
      const auto at = static_cast<std::size_t>(axis);
      Plot plot = parameter_plot(is_size ? sizes[at] : positions[at], values, learned.mean[axis],
                                 learned.stddev[axis], colour);
      char note[96];
      std::snprintf(note, sizeof note, "template %.3g ± %.2g", learned.mean[axis], learned.stddev[axis]);
      plot.note = count_of(values.values.size(), "shape") + ", " + note;
      figure.panels.push_back(std::move(plot));
    }
  }
  return figure;
}

}  // namespace archetype
