// What the parts of drawing a plot share. Not for others.
#pragma once

#include <string>

#include "core/report/plot_drawing.h"

namespace archetype {

struct PlotArea {
  PlotPoint low;
  PlotPoint high;
  float width() const { return high.x - low.x; }
  float height() const { return high.y - low.y; }
};

struct PlotCanvas {
  const PlotSpace& space;
  PlotDrawing& out;

  float width(const std::string& text, TextKind kind = TextKind::normal) const {
    return space.text_width(text, kind);
  }
  void text(PlotPoint at, const std::string& text, Ink ink = Ink::muted, float anchor = 0,
            TextKind kind = TextKind::normal) const;
  void line(std::vector<PlotPoint> points, Ink ink, float width = 1) const;
  void rule(PlotPoint a, PlotPoint b, Ink ink) const { line({a, b}, ink); }
};

// One line without control characters, cut with "…" to a width. Cost: bounded, however long the text is.
std::string short_line(const PlotCanvas& canvas, const std::string& text, float width,
                       TextKind kind = TextKind::normal);
// A value of an axis as a person reads it: "12.5 %", "0.0123".
std::string value_text(const PlotAxis& axis, double value);

void draw_axes_plot(const PlotCanvas& canvas, const Plot& plot, const PlotArea& area);
void draw_bars_plot(const PlotCanvas& canvas, const Plot& plot, const PlotArea& area);
void draw_matrix_plot(const PlotCanvas& canvas, const PlotMatrix& matrix, const PlotArea& area);

}  // namespace archetype
