// Series over numbers: lines, dots and bars between two axes.
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/report/axis_marks.h"
#include "core/report/plot_canvas.h"

namespace archetype {
namespace {

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  void add(double value) {
    if (!std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

bool drawn(const PlotSeries& series, std::size_t i) {
  return std::isfinite(series.x[i]) && std::isfinite(series.y[i]);
}

std::size_t point_count(const PlotSeries& series) {
  return std::min(series.x.size(), series.y.size());
}

// Of one direction: where its ends and its marks are.
struct Scale {
  double low = 0;
  double high = 1;
  double step = 1;
  std::vector<double> marks;
  double share(double value) const { return std::clamp((value - low) / (high - low), -1.0, 2.0); }
};

Scale scale_of(const PlotAxis& axis, Range range, std::size_t most) {
  // Differences of larger numbers are lost, and nobody means them.
  constexpr double largest = 1e100;
  if (axis.low) range.low = *axis.low;
  if (axis.high) range.high = *axis.high;
  if (!(range.low <= range.high)) range = {0, 1};
  range.low = std::clamp(range.low, -largest, largest);
  range.high = std::clamp(range.high, -largest, largest);
  Scale scale;
  // Where the ends are given, the outer marks fall away.
  const std::size_t outer = (axis.low ? 1u : 0u) + (axis.high ? 1u : 0u);
  scale.marks = axis_marks(range.low, range.high, std::max<std::size_t>(3, most + outer));
  scale.step = scale.marks[1] - scale.marks[0];
  if (axis.whole && scale.step < 1) {
    const double first = std::floor(range.low);
    const double last = std::max(std::ceil(range.high), first + 1);
    scale.marks.clear();
    for (double mark = first; mark <= last; ++mark) scale.marks.push_back(mark);
    scale.step = 1;
  }
  scale.low = axis.low.value_or(scale.marks.front());
  scale.high = axis.high.value_or(scale.marks.back());
  if (!(scale.high > scale.low)) {
    scale.low = scale.marks.front();
    scale.high = scale.marks.back();
  }
  const double slack = 1e-9 * (scale.high - scale.low);
  std::erase_if(scale.marks, [&](double m) { return m < scale.low - slack || m > scale.high + slack; });
  return scale;
}

std::string mark_label(const PlotAxis& axis, const Scale& scale, double mark) {
  return axis.percent ? mark_text(100 * mark, 100 * scale.step) + " %" : mark_text(mark, scale.step);
}

struct Axes {
  const PlotCanvas& canvas;
  const Plot& plot;
  PlotArea area;  // between the axes
  Scale x;
  Scale y;

  PlotPoint at(double px, double py) const {
    return {area.low.x + area.width() * static_cast<float>(x.share(px)),
            area.high.y - area.height() * static_cast<float>(y.share(py))};
  }
  bool within(double px, double py) const {
    return px >= x.low && px <= x.high && py >= y.low && py <= y.high;
  }
};

void draw_frame(const Axes& axes) {
  const PlotCanvas& canvas = axes.canvas;
  const float line = canvas.space.line;
  for (const double mark : axes.y.marks) {
    const float y = axes.at(axes.x.low, mark).y;
    canvas.rule({axes.area.low.x, y}, {axes.area.high.x, y}, Ink::grid);
    canvas.text({axes.area.low.x - 0.4f * line, y - line / 2}, mark_label(axes.plot.y, axes.y, mark),
                Ink::muted, 1);
  }
  canvas.rule({axes.area.low.x, axes.area.high.y}, axes.area.high, Ink::muted);
  float free_from = -1e9f;
  for (const double mark : axes.x.marks) {
    const float x = axes.at(mark, axes.y.low).x;
    canvas.rule({x, axes.area.high.y}, {x, axes.area.high.y + 0.25f * line}, Ink::muted);
    const std::string text = mark_label(axes.plot.x, axes.x, mark);
    const float half = canvas.width(text) / 2;
    if (x - half < free_from) continue;
    free_from = x + half + 0.5f * line;
    canvas.text({x, axes.area.high.y + 0.3f * line}, text, Ink::muted, 0.5f);
  }
}

std::string told(const Plot& plot, const PlotSeries& series, std::size_t i) {
  std::string text = series.name.empty() ? "" : series.name + "\n";
  const std::string x_name = plot.x.label.empty() ? "" : plot.x.label + ": ";
  const std::string y_name = plot.y.label.empty() ? "" : plot.y.label + ": ";
  if (series.kind == SeriesKind::bars) {
    text += x_name + value_text(plot.x, series.x[i] - series.bar_width / 2) + " to " +
            value_text(plot.x, series.x[i] + series.bar_width / 2);
  } else {
    text += x_name + value_text(plot.x, series.x[i]);
  }
  text += "\n" + y_name + value_text(plot.y, series.y[i]);
  if (i < series.notes.size() && !series.notes[i].empty()) text += "\n" + series.notes[i];
  return text;
}

void draw_bars(const Axes& axes, std::size_t number) {
  const PlotSeries& series = axes.plot.series[number];
  const double base = std::clamp(0.0, axes.y.low, axes.y.high);
  for (std::size_t i = 0; i < point_count(series); ++i) {
    if (!drawn(series, i)) continue;
    PlotPoint a = axes.at(series.x[i] - series.bar_width / 2, base);
    PlotPoint b = axes.at(series.x[i] + series.bar_width / 2, series.y[i]);
    if (b.y > a.y) std::swap(a.y, b.y);
    a.y = std::clamp(a.y, axes.area.low.y, axes.area.high.y);
    b.y = std::clamp(b.y, axes.area.low.y, axes.area.high.y);
    a.x = std::clamp(a.x, axes.area.low.x, axes.area.high.x);
    b.x = std::clamp(b.x, axes.area.low.x, axes.area.high.x);
    if (!(b.x > a.x)) continue;
    const float gap = std::min(0.5f * axes.canvas.space.scale, (b.x - a.x) * 0.1f);
    axes.canvas.out.marks.emplace_back(DrawnArea{{a.x + gap, b.y}, {b.x - gap, a.y}, series.colour, 0.75f});
    axes.canvas.out.values.push_back({.low = {a.x, axes.area.low.y},
                                      .high = {b.x, a.y},
                                      .text = told(axes.plot, series, i),
                                      .series = number,
                                      .point = i,
                                      .bar = DrawnBar{{a.x + gap, b.y}, {b.x - gap, a.y}}});
  }
}

void draw_points(const Axes& axes, std::size_t number) {
  const PlotSeries& series = axes.plot.series[number];
  const float scale = axes.canvas.space.scale;
  const bool has_line = series.kind != SeriesKind::dots;
  const bool has_dots = series.kind != SeriesKind::line;
  std::vector<PlotPoint> run;
  const auto end_run = [&] {
    if (run.size() > 1 && has_line)
      axes.canvas.out.marks.emplace_back(DrawnLine{run, Ink::data, series.colour, 2 * scale, series.dashed});
    run.clear();
  };
  const float reach = 7 * scale;
  for (std::size_t i = 0; i < point_count(series); ++i) {
    if (!drawn(series, i) || !axes.within(series.x[i], series.y[i])) {
      end_run();
      continue;
    }
    run.push_back(axes.at(series.x[i], series.y[i]));
    axes.canvas.out.values.push_back({.low = {run.back().x - reach, run.back().y - reach},
                                      .high = {run.back().x + reach, run.back().y + reach},
                                      .text = told(axes.plot, series, i),
                                      .series = number,
                                      .point = i});
  }
  end_run();
  for (std::size_t i = 0; i < point_count(series) && has_dots; ++i)
    if (drawn(series, i) && axes.within(series.x[i], series.y[i]))
      axes.canvas.out.marks.emplace_back(
          DrawnSpot{axes.at(series.x[i], series.y[i]), 3.2f * scale, series.colour});
}

void add_ranges(const Plot& plot, Range& x, Range& y) {
  for (const PlotSeries& series : plot.series) {
    const double half = series.kind == SeriesKind::bars ? series.bar_width / 2 : 0;
    for (std::size_t i = 0; i < point_count(series); ++i) {
      if (!drawn(series, i)) continue;
      x.add(series.x[i] - half);
      x.add(series.x[i] + half);
      y.add(series.y[i]);
      if (series.kind == SeriesKind::bars) y.add(0);
    }
  }
}

}  // namespace

void draw_axes_plot(const PlotCanvas& canvas, const Plot& plot, const PlotArea& area) {
  const float line = canvas.space.line;
  Range range_x, range_y;
  add_ranges(plot, range_x, range_y);
  Axes axes{canvas, plot, area, {}, {}};
  if (!plot.y.label.empty()) {
    canvas.text(area.low, short_line(canvas, plot.y.label, area.width()));
    axes.area.low.y += 1.2f * line;
  }
  axes.area.low.y += 0.6f * line;
  axes.area.high.y -= (plot.x.label.empty() ? 1.5f : 2.8f) * line;
  if (axes.area.height() < 2 * line) return;
  axes.y = scale_of(plot.y, range_y, static_cast<std::size_t>(axes.area.height() / (1.8f * line)));
  float widest = 0;
  for (const double mark : axes.y.marks)
    widest = std::max(widest, canvas.width(mark_label(plot.y, axes.y, mark)));
  axes.area.low.x += std::min(widest + 0.7f * line, area.width() / 2);
  axes.area.high.x -= line;
  axes.x = scale_of(plot.x, range_x, static_cast<std::size_t>(axes.area.width() / (3.2f * line)));
  draw_frame(axes);
  if (!plot.x.label.empty())
    canvas.text({axes.area.high.x, area.high.y - 1.2f * line}, short_line(canvas, plot.x.label, area.width()),
                Ink::muted, 1);
  for (std::size_t s = 0; s < plot.series.size(); ++s)
    if (plot.series[s].kind == SeriesKind::bars) draw_bars(axes, s);
  for (std::size_t s = 0; s < plot.series.size(); ++s)
    if (plot.series[s].kind != SeriesKind::bars) draw_points(axes, s);
}

}  // namespace archetype
