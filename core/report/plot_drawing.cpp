// Title, note, legend and panels; what is inside the axes has files of its own.
#include "core/report/plot_drawing.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/report/plot_canvas.h"

namespace archetype {
namespace {

constexpr std::size_t longest_line = 160;  // bytes of a name that are looked at

// The longest prefix of at most `most` bytes that does not end within a character.
std::string prefix(const std::string& text, std::size_t most) {
  if (text.size() <= most) return text;
  while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xC0) == 0x80) --most;
  return text.substr(0, most);
}

bool in_legend(const Plot& plot) {
  return !plot.matrix &&
         std::ranges::any_of(plot.series, [](const PlotSeries& series) { return !series.name.empty(); });
}

// Names with their colours, line after line. Returns the height that they take.
float draw_legend(const PlotCanvas& canvas, const Plot& plot, PlotPoint low, float width) {
  const float line = canvas.space.line;
  const float swatch = 1.2f * line;
  float x = low.x;
  float y = low.y;
  for (const PlotSeries& series : plot.series) {
    if (series.name.empty()) continue;
    const std::string name = short_line(canvas, series.name, width - swatch);
    const float wide = swatch + canvas.width(name) + line;
    if (x > low.x && x + wide - line > low.x + width) {
      x = low.x;
      y += 1.2f * line;
    }
    if (series.kind == SeriesKind::bars) {
      canvas.out.marks.emplace_back(
          DrawnArea{{x, y + 0.2f * line}, {x + 0.8f * line, y + 0.85f * line}, series.colour, 1});
    } else {
      canvas.out.marks.emplace_back(DrawnLine{{{x, y + 0.5f * line}, {x + 0.95f * line, y + 0.5f * line}},
                                              Ink::data,
                                              series.colour,
                                              2 * canvas.space.scale,
                                              series.dashed});
    }
    canvas.text({x + swatch, y}, name, Ink::text);
    x += wide;
  }
  return y - low.y + 1.4f * line;
}

void draw_into(PlotDrawing& out, const Plot& plot, const PlotSpace& space, PlotArea area) {
  const PlotCanvas canvas{space, out};
  const float line = space.line;
  if (!plot.title.empty()) {
    canvas.text(area.low, short_line(canvas, plot.title, area.width(), TextKind::title), Ink::text, 0,
                TextKind::title);
    area.low.y += 1.3f * line;
  }
  if (!plot.note.empty()) {
    canvas.text(area.low, short_line(canvas, plot.note, area.width()));
    area.low.y += 1.3f * line;
  }
  if (in_legend(plot)) area.low.y += draw_legend(canvas, plot, area.low, area.width());
  if (area.height() < 2 * line || area.width() < 4 * line) return;
  if (plot.matrix)
    draw_matrix_plot(canvas, *plot.matrix, area);
  else if (!plot.categories.empty())
    draw_bars_plot(canvas, plot, area);
  else
    draw_axes_plot(canvas, plot, area);
}

// Below it the names of columns, or of marks, would be cut or left out.
float readable_width(const Plot& plot, float line) {
  if (!plot.matrix) return 15 * line;
  return (8 + 4.5f * static_cast<float>(std::min<std::size_t>(plot.matrix->columns.size(), 12))) * line;
}

float middle_distance(const HoverValue& value, float x, float y) {
  return std::hypot((value.low.x + value.high.x) / 2 - x, (value.low.y + value.high.y) / 2 - y);
}

}  // namespace

void PlotCanvas::text(PlotPoint at, const std::string& text, Ink ink, float anchor, TextKind kind) const {
  if (!text.empty()) out.marks.emplace_back(DrawnText{at, anchor, text, kind, ink, {}});
}

void PlotCanvas::line(std::vector<PlotPoint> points, Ink ink, float width) const {
  out.marks.emplace_back(DrawnLine{std::move(points), ink, {}, width * space.scale, false});
}

std::string short_line(const PlotCanvas& canvas, const std::string& text, float width, TextKind kind) {
  std::string line = prefix(text, longest_line);
  for (char& c : line)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = ' ';
  if (line.size() == text.size() && canvas.width(line, kind) <= width) return line;
  while (!line.empty() && canvas.width(line + "…", kind) > width) line = prefix(line, line.size() - 1);
  return line.empty() ? "" : line + "…";
}

std::string value_text(const PlotAxis& axis, double value) {
  char text[48];
  if (axis.percent)
    std::snprintf(text, sizeof text, "%.1f %%", 100 * value);
  else if (value == std::round(value) && std::abs(value) < 1e15)
    std::snprintf(text, sizeof text, "%.0f", value);
  else
    std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

float readable_height(const Plot& plot, float line) {
  const float head = 5 * line;
  if (plot.matrix) return head + 1.6f * line * static_cast<float>(plot.matrix->rows.size() + 3);
  if (plot.categories.empty()) return head + 8 * line;
  const auto bars = static_cast<float>(std::max<std::size_t>(1, plot.series.size()));
  const float row = std::max(1.3f, 0.5f * bars + 0.4f) * line;
  return head + 3 * line + row * static_cast<float>(plot.categories.size());
}

PlotDrawing draw_plot(const Plot& plot, const PlotSpace& space) {
  PlotDrawing out{space.width, space.height, {}, {}};
  draw_into(out, plot, space, {{0, 0}, {space.width, space.height}});
  return out;
}

PlotDrawing draw_figure(const Figure& figure, const PlotSpace& space) {
  PlotDrawing out{space.width, space.height, {}, {}};
  if (figure.panels.empty()) return out;
  const float gap = 1.5f * space.line;
  float least = 0;
  for (const Plot& panel : figure.panels) least = std::max(least, readable_width(panel, space.line));
  const auto fitting = static_cast<std::size_t>(std::max(1.0f, (space.width + gap) / (least + gap)));
  const std::size_t columns =
      std::clamp<std::size_t>(figure.columns, 1, std::min(fitting, figure.panels.size()));
  const std::size_t rows = (figure.panels.size() + columns - 1) / columns;
  const float width = (space.width - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns);
  const float even = (space.height - gap * static_cast<float>(rows - 1)) / static_cast<float>(rows);
  float top = 0;
  for (std::size_t row = 0; row < rows; ++row) {
    const std::size_t first = row * columns;
    const std::size_t end = std::min(first + columns, figure.panels.size());
    float height = even;
    for (std::size_t i = first; i < end; ++i)
      height = std::max(height, readable_height(figure.panels[i], space.line));
    for (std::size_t i = first; i < end; ++i) {
      const float left = static_cast<float>(i - first) * (width + gap);
      const std::size_t before = out.values.size();
      draw_into(out, figure.panels[i], space, {{left, top}, {left + width, top + height}});
      for (std::size_t v = before; v < out.values.size(); ++v) out.values[v].panel = i;
    }
    top += height + gap;
  }
  out.height = top - gap;
  return out;
}

std::optional<std::size_t> value_at(const PlotDrawing& drawing, float x, float y) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < drawing.values.size(); ++i) {
    const HoverValue& value = drawing.values[i];
    if (x < value.low.x || x > value.high.x || y < value.low.y || y > value.high.y) continue;
    if (!best || middle_distance(value, x, y) < middle_distance(drawing.values[*best], x, y)) best = i;
  }
  return best;
}

}  // namespace archetype
