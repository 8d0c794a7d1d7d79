// A plot as lines, areas and texts at places, so that the window and files show the same picture.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/report/plot.h"

namespace archetype {

enum class Ink { data, text, muted, grid };  // data: the colour of the mark; the others follow the theme
enum class TextKind { normal, title };

struct PlotPoint {
  float x = 0;
  float y = 0;
};
struct DrawnLine {
  std::vector<PlotPoint> points;
  Ink ink = Ink::data;
  Rgb colour{};
  float width = 1;
  bool dashed = false;
};
struct DrawnArea {
  PlotPoint low;
  PlotPoint high;
  Rgb colour{};
  float opacity = 1;
  bool of_scale = false;  // the colour stands for a number, and is the same on any ground
};
struct DrawnSpot {
  PlotPoint at;
  float radius = 3;
  Rgb colour{};
};
struct DrawnText {
  PlotPoint at;      // of its upper left, upper middle or upper right corner
  float anchor = 0;  // 0: left, 0.5: middle, 1: right
  std::string text;
  TextKind kind = TextKind::normal;
  Ink ink = Ink::text;
  Rgb colour{};
};
using DrawnMark = std::variant<DrawnLine, DrawnArea, DrawnSpot, DrawnText>;

// The bar of a value: from the axis at its foot to its end.
struct DrawnBar {
  PlotPoint low;
  PlotPoint high;
  bool upright = true;  // it grows upwards, else to the right
};

// A place that has something to say when the mouse is there.
struct HoverValue {
  PlotPoint low;
  PlotPoint high;
  std::string text;  // lines
  // What of the figure it is; of a matrix neither series nor point.
  std::size_t panel = 0;
  std::size_t series = 0;
  std::size_t point = 0;
  std::optional<DrawnBar> bar = {};
};

struct PlotDrawing {
  float width = 0;
  float height = 0;
  std::vector<DrawnMark> marks;  // in the order of painting
  std::vector<HoverValue> values;
};

// How wide texts are and how much place there is. All in the same unit: pixels, say.
struct PlotSpace {
  float width = 640;
  float height = 420;
  float line = 16;  // height of a line of text
  float scale = 1;  // of widths of lines
  std::function<float(const std::string&, TextKind)> text_width;
};

PlotDrawing draw_plot(const Plot& plot, const PlotSpace& space);
// The height below which a plot gets unreadable: names and rows need a line each.
float readable_height(const Plot& plot, float line);

// A figure's panels in its columns, as many as fit readably into space.width. The height is that of the space
// where the panels are readable in it, and more otherwise.
PlotDrawing draw_figure(const Figure& figure, const PlotSpace& space);

// What is at a place, the nearest if several are; nothing where nothing is.
std::optional<std::size_t> value_at(const PlotDrawing& drawing, float x, float y);

}  // namespace archetype
