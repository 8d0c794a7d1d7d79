// Plots as plain data: what they say, whoever draws or tabulates it (plot_drawing.h, svg.h, csv.h).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/io/project.h"
#include "core/model/part_colours.h"

namespace archetype {

enum class SeriesKind { line, dots, line_and_dots, bars };

// All arrays have one entry per point. What is not finite is left out.
struct PlotSeries {
  std::string name = {};  // in the legend
  SeriesKind kind = SeriesKind::line;
  Rgb colour{};
  bool dashed = false;
  double bar_width = 1;  // of bars over numbers, in units of x; x is their middle
  std::vector<double> x = {};
  std::vector<double> y = {};
  std::vector<std::string> notes = {};  // what else there is to say of a point; empty: nothing of any
  // The shapes that a point stands for, in the collection's order; empty: of none is it known.
  std::vector<std::vector<ShapeId>> shapes = {};
};

// A part by the names that people call it.
struct NamedPart {
  std::string part_template;
  std::string part;
  friend bool operator==(const NamedPart&, const NamedPart&) = default;
};

struct PlotAxis {
  std::string label = {};
  std::optional<double> low = {};  // where it ends; nothing: at a round number about the values
  std::optional<double> high = {};
  bool percent = false;  // values are fractions, shown as percent
  bool whole = false;    // no marks between whole numbers
};

// Shares that belong to pairs, as colours with numbers.
struct PlotMatrix {
  std::string row_label = {};
  std::string column_label = {};
  std::vector<std::string> rows = {};
  std::vector<std::string> columns = {};
  std::vector<double> values = {};  // from 0 to 1, row by row
};

struct Plot {
  std::string title = {};
  std::string note = {};  // a line below it: what was counted
  PlotAxis x = {};
  PlotAxis y = {};
  // Not empty: all series are bars that lie beside these names, each at the one that its x is the index of.
  // The values are still those of `y`, though that axis lies flat then.
  std::vector<std::string> categories = {};
  std::vector<NamedPart> parts = {};  // that the categories are; empty: they are none
  std::vector<PlotSeries> series = {};
  std::optional<PlotMatrix> matrix = {};  // drawn instead of axes and series
};

// What is looked at and exported together.
struct Figure {
  std::string name = {};  // of files: "part-sizes"
  std::string title = {};
  std::vector<Plot> panels = {};
  std::size_t columns = 1;  // of panels, at most
};

// Colours for series that are no parts: for colour-blind readers, they repeat after eight.
Rgb series_colour(std::size_t index);

}  // namespace archetype
