// Bars beside names, and matrices: both have rows.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/report/axis_marks.h"
#include "core/report/plot_canvas.h"

namespace archetype {
namespace {

float widest_of(const PlotCanvas& canvas, const std::vector<std::string>& names, float most) {
  float widest = 0;
  for (const std::string& name : names) {
    widest = std::max(widest, canvas.width(short_line(canvas, name, most)));
    if (widest > 0.98f * most) return most;
  }
  return widest;
}

// How many rows share one name where there is no room for all.
std::size_t rows_a_name(float row, float line) {
  return static_cast<std::size_t>(std::max(1.0f, std::ceil(line / std::max(row, 0.01f))));
}

// From 0, or below it, to the end of the axis.
struct FlatScale {
  double low = 0;
  double high = 1;
  std::vector<double> marks;
};

FlatScale flat_scale(const Plot& plot, float width, float line) {
  double low = plot.y.low.value_or(0);
  double high = plot.y.high.value_or(0);
  for (const PlotSeries& series : plot.series) {
    for (const double value : series.y) {
      if (!std::isfinite(value) || std::abs(value) > 1e100) continue;
      low = plot.y.low ? low : std::min(low, value);
      high = plot.y.high ? high : std::max(high, value);
    }
  }
  if (!(high > low)) high = low + 1;
  FlatScale scale;
  scale.marks = axis_marks(low, high, static_cast<std::size_t>(std::max(3.0f, width / (4 * line))));
  if (plot.y.whole && scale.marks[1] - scale.marks[0] < 1)
    scale.marks = {std::floor(low), std::max(std::ceil(high), std::floor(low) + 1)};
  scale.low = scale.marks.front();
  scale.high = scale.marks.back();
  return scale;
}

void draw_flat_frame(const PlotCanvas& canvas, const Plot& plot, const PlotArea& area,
                     const FlatScale& scale) {
  const float line = canvas.space.line;
  for (const double mark : scale.marks) {
    const float x =
        area.low.x + area.width() * static_cast<float>((mark - scale.low) / (scale.high - scale.low));
    canvas.rule({x, area.low.y}, {x, area.high.y}, Ink::grid);
    const double step = scale.marks[1] - scale.marks[0];
    const std::string text =
        plot.y.percent ? mark_text(100 * mark, 100 * step) + " %" : mark_text(mark, step);
    canvas.text({x, area.high.y + 0.3f * line}, text, Ink::muted, 0.5f);
  }
  canvas.rule(area.low, {area.low.x, area.high.y}, Ink::muted);
}

void draw_bar(const PlotCanvas& canvas, const Plot& plot, std::size_t number, std::size_t i,
              const PlotArea& bar, float free_to) {
  const PlotSeries& series = plot.series[number];
  canvas.out.marks.emplace_back(DrawnArea{bar.low, bar.high, series.colour, 0.9f});
  std::string told = plot.categories[static_cast<std::size_t>(series.x[i])];
  const std::string value = value_text(plot.y, series.y[i]);
  if (!series.name.empty()) told.append("\n").append(series.name);
  told.append("\n").append(plot.y.label).append(plot.y.label.empty() ? "" : ": ").append(value);
  if (i < series.notes.size() && !series.notes[i].empty()) told.append("\n").append(series.notes[i]);
  canvas.out.values.push_back({.low = bar.low,
                               .high = {free_to, bar.high.y},
                               .text = told,
                               .series = number,
                               .point = i,
                               .bar = DrawnBar{bar.low, bar.high, false}});
  const float line = canvas.space.line;
  if (bar.height() < 0.82f * line) return;  // it would reach into the bar below
  const float top = (bar.low.y + bar.high.y - line) / 2;
  const float wide = canvas.width(value) + 0.4f * line;
  if (bar.high.x + wide <= free_to)
    canvas.text({bar.high.x + 0.3f * line, top}, value);
  else if (bar.width() > wide)
    canvas.out.marks.emplace_back(
        DrawnText{{bar.high.x - 0.3f * line, top}, 1, value, TextKind::normal, Ink::data, {255, 255, 255}});
}

std::string percent_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, value > 0.0005 && value < 0.995 ? "%.1f" : "%.0f", 100 * value);
  return text;
}

// A pale yellow to a dark blue that black and white numbers can be read on (after ColorBrewer's YlGnBu).
Rgb matrix_colour(double value) {
  constexpr std::array<Rgb, 5> stops{
      {{255, 255, 230}, {199, 233, 190}, {97, 190, 193}, {40, 120, 180}, {20, 45, 115}}};
  const double at = std::clamp(value, 0.0, 1.0) * static_cast<double>(stops.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(at), stops.size() - 2);
  const double share = at - static_cast<double>(below);
  Rgb colour{};
  for (std::size_t c = 0; c < colour.size(); ++c)
    colour[c] =
        static_cast<std::uint8_t>(std::lround(stops[below][c] * (1 - share) + stops[below + 1][c] * share));
  return colour;
}

}  // namespace

void draw_bars_plot(const PlotCanvas& canvas, const Plot& plot, const PlotArea& given) {
  const float line = canvas.space.line;
  PlotArea area = given;
  const float names = widest_of(canvas, plot.categories, 0.35f * given.width());
  area.low.x += names + 0.6f * line;
  area.high.x -= 1.5f * line;
  area.high.y -= (plot.y.label.empty() ? 1.5f : 2.8f) * line;
  if (area.width() < 3 * line || area.height() < line) return;
  // A few bars need not be as high as the place for many is.
  const auto rows = static_cast<float>(plot.categories.size());
  const float row = std::min(area.height() / rows, 3.2f * line);
  area.high.y = area.low.y + row * rows;
  const FlatScale scale = flat_scale(plot, area.width(), line);
  draw_flat_frame(canvas, plot, area, scale);
  if (!plot.y.label.empty())
    canvas.text({area.high.x, area.high.y + 1.6f * line}, short_line(canvas, plot.y.label, given.width()),
                Ink::muted, 1);
  const std::size_t every = rows_a_name(row, line);
  for (std::size_t c = 0; c < plot.categories.size(); c += every)
    canvas.text({area.low.x - 0.4f * line, area.low.y + row * (static_cast<float>(c) + 0.5f) - line / 2},
                short_line(canvas, plot.categories[c], names), Ink::text, 1);
  const float thick = 0.8f * row / static_cast<float>(std::max<std::size_t>(1, plot.series.size()));
  const auto x_of = [&](double value) {
    const double share = std::clamp((value - scale.low) / (scale.high - scale.low), 0.0, 1.0);
    return area.low.x + area.width() * static_cast<float>(share);
  };
  for (std::size_t s = 0; s < plot.series.size(); ++s) {
    const PlotSeries& series = plot.series[s];
    for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
      const double c = series.x[i];
      if (!std::isfinite(series.y[i]) || !(c >= 0 && c < static_cast<double>(plot.categories.size())))
        continue;
      const float top = area.low.y + row * (static_cast<float>(c) + 0.1f) + thick * static_cast<float>(s);
      const float base = x_of(0);
      const float end = x_of(series.y[i]);
      draw_bar(canvas, plot, s, i, {{std::min(base, end), top}, {std::max(base, end), top + 0.94f * thick}},
               given.high.x);
    }
  }
}

void draw_matrix_plot(const PlotCanvas& canvas, const PlotMatrix& matrix, const PlotArea& given) {
  const float line = canvas.space.line;
  if (matrix.rows.empty() || matrix.columns.empty()) return;
  const float names = widest_of(canvas, matrix.rows, 0.3f * given.width());
  PlotArea area = given;
  area.low.x += names + 0.6f * line;
  area.low.y += 2.6f * line;
  if (area.width() < line || area.height() < line) return;
  const auto columns = static_cast<float>(matrix.columns.size());
  const float wide = std::min(area.width() / columns, 7 * line);
  const float row = std::min(area.height() / static_cast<float>(matrix.rows.size()), 2.4f * line);
  canvas.text({area.low.x, given.low.y},
              short_line(canvas, matrix.column_label + "; rows: " + matrix.row_label, area.width()));
  const auto every_column = rows_a_name(wide, 2.2f * line);
  for (std::size_t c = 0; c < matrix.columns.size(); c += every_column)
    canvas.text({area.low.x + wide * (static_cast<float>(c) + 0.5f), given.low.y + 1.3f * line},
                short_line(canvas, matrix.columns[c], wide * static_cast<float>(every_column) - 0.2f * line),
                Ink::text, 0.5f);
  const std::size_t every_row = rows_a_name(row, line);
  const bool numbers = wide > 2.4f * line && row > line;
  for (std::size_t r = 0; r < matrix.rows.size(); ++r) {
    const float top = area.low.y + row * static_cast<float>(r);
    if (r % every_row == 0)
      canvas.text({area.low.x - 0.4f * line, top + row / 2 - line / 2},
                  short_line(canvas, matrix.rows[r], names), Ink::text, 1);
    for (std::size_t c = 0; c < matrix.columns.size(); ++c) {
      const double value = matrix.values[r * matrix.columns.size() + c];
      const PlotPoint low{area.low.x + wide * static_cast<float>(c), top};
      const PlotPoint high{low.x + wide, top + row};
      if (!std::isfinite(value)) continue;
      canvas.out.marks.emplace_back(DrawnArea{low, high, matrix_colour(value), 1, true});
      canvas.out.values.push_back(
          {.low = low,
           .high = high,
           .text = matrix.rows[r] + " / " + matrix.columns[c] + "\n" + percent_text(value) + " %"});
      if (!numbers) continue;
      const Rgb ink = value > 0.55 ? Rgb{255, 255, 255} : Rgb{30, 30, 30};
      canvas.out.marks.emplace_back(DrawnText{{low.x + wide / 2, top + row / 2 - line / 2},
                                              0.5f,
                                              percent_text(value),
                                              TextKind::normal,
                                              Ink::data,
                                              ink});
    }
  }
}

}  // namespace archetype
