#include "core/report/figure_files.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/io/file.h"
#include "core/report/plot_drawing.h"
#include "core/report/xml_text.h"

namespace archetype {
namespace {

constexpr float font_size = 13;
constexpr float margin = 18;

// About the widths of Helvetica and its kin, in parts of the font's size: no font is at hand here, and the
// reader's may be another one anyway.
float glyph_width(unsigned char c) {
  if (c >= 0x80) return 0.6f;
  switch (c) {
    case 'i':
    case 'j':
    case 'l':
    case '.':
    case ',':
    case ':':
    case ';':
    case '\'':
    case '|':
    case '!':
      return 0.25f;
    case 'f':
    case 't':
    case 'r':
    case ' ':
    case '(':
    case ')':
    case '-':
      return 0.33f;
    case 'm':
    case 'w':
    case 'M':
    case 'W':
    case '@':
    case '%':
      return 0.87f;
    default:
      return c >= 'A' && c <= 'Z' ? 0.69f : 0.56f;
  }
}

float text_width(const std::string& text, TextKind kind) {
  float width = 0;
  for (const char c : text)
    if ((static_cast<unsigned char>(c) & 0xC0) != 0x80) width += glyph_width(static_cast<unsigned char>(c));
  return width * font_size * (kind == TextKind::title ? 1.15f : 1.0f);
}

// To a hundredth of a pixel.
std::string length(float value) {
  if (!std::isfinite(value)) value = 0;
  return number_text(std::round(static_cast<double>(value) * 100) / 100);
}

std::string hex(const Rgb& colour) {
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", colour[0], colour[1], colour[2]);
  return text;
}

std::string ink_colour(Ink ink, const Rgb& colour) {
  switch (ink) {
    case Ink::data:
      return hex(colour);
    case Ink::text:
      return "#1b1e22";
    case Ink::muted:
      return "#5b626b";
    case Ink::grid:
      return "#e1e4e8";
  }
  return "#000000";
}

struct SvgWriter {
  std::string& out;

  void operator()(const DrawnLine& line) const {
    out += "<polyline fill=\"none\" stroke=\"" + ink_colour(line.ink, line.colour) + "\" stroke-width=\"" +
           length(line.width) + "\" stroke-linejoin=\"round\"";
    if (line.dashed) out += " stroke-dasharray=\"6 4\"";
    out += " points=\"";
    for (const PlotPoint& point : line.points) out += length(point.x) + "," + length(point.y) + " ";
    out += "\"/>\n";
  }
  void operator()(const DrawnArea& area) const {
    out += "<rect x=\"" + length(area.low.x) + "\" y=\"" + length(area.low.y) + "\" width=\"" +
           length(std::max(0.0f, area.high.x - area.low.x)) + "\" height=\"" +
           length(std::max(0.0f, area.high.y - area.low.y)) + "\" fill=\"" + hex(area.colour) + "\"";
    if (area.opacity < 1) out += " fill-opacity=\"" + length(area.opacity) + "\"";
    out += "/>\n";
  }
  void operator()(const DrawnSpot& spot) const {
    out += "<circle cx=\"" + length(spot.at.x) + "\" cy=\"" + length(spot.at.y) + "\" r=\"" +
           length(spot.radius) + "\" fill=\"" + hex(spot.colour) + "\"/>\n";
  }
  void operator()(const DrawnText& text) const {
    out += "<text x=\"" + length(text.at.x) + "\" y=\"" + length(text.at.y + 0.95f * font_size) +
           "\" fill=\"" + ink_colour(text.ink, text.colour) + "\"";
    if (text.anchor > 0) out += text.anchor < 0.75f ? " text-anchor=\"middle\"" : " text-anchor=\"end\"";
    if (text.kind == TextKind::title) out += " font-weight=\"bold\"";
    out.append(">").append(xml_text(text.text)).append("</text>\n");
  }
};

// Nothing that is seen, but what a reader shows where the mouse rests.
std::string hover_mark(const HoverValue& value) {
  return "<rect x=\"" + length(value.low.x) + "\" y=\"" + length(value.low.y) + "\" width=\"" +
         length(std::max(0.0f, value.high.x - value.low.x)) + "\" height=\"" +
         length(std::max(0.0f, value.high.y - value.low.y)) +
         "\" fill=\"none\" pointer-events=\"all\"><title>" + xml_text(value.text) + "</title></rect>\n";
}

std::string quoted(const std::string& field) {
  if (field.find_first_of(",\"\r\n") == std::string::npos &&
      (field.empty() || (field.front() != ' ' && field.back() != ' ')))
    return field;
  std::string text = "\"";
  for (const char c : field) {
    if (c == '"') text += '"';
    text += c;
  }
  return text + '"';
}

void add_line(std::string& out, const std::string& plot, const std::string& series, const std::string& x,
              double y, const std::string& note) {
  out += quoted(plot) + ',' + quoted(series) + ',' + quoted(x) + ',' + number_text(y) + ',' + quoted(note) +
         '\n';
}

void add_lines(std::string& out, const Plot& plot, const PlotSeries& series) {
  for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
    const double x = series.x[i];
    if (!std::isfinite(x) || !std::isfinite(series.y[i])) continue;
    const bool named = x >= 0 && x < static_cast<double>(plot.categories.size());
    if (!plot.categories.empty() && !named) continue;
    add_line(out, plot.title, series.name,
             named ? plot.categories[static_cast<std::size_t>(x)] : number_text(x), series.y[i],
             i < series.notes.size() ? series.notes[i] : "");
  }
}

}  // namespace

std::string to_svg(const Figure& figure, const SvgOptions& options) {
  PlotSpace space;
  space.width = std::max(100.0f, options.width - 2 * margin);
  space.line = 1.25f * font_size;
  const float head = figure.title.empty() ? 0 : 2 * space.line;
  space.height = std::max(100.0f, options.height - 2 * margin - head);
  space.text_width = text_width;
  const PlotDrawing drawing = draw_figure(figure, space);
  const std::string width = length(drawing.width + 2 * margin);
  const std::string height = length(drawing.height + 2 * margin + head);
  std::string out =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" +
      width + "\" height=\"" + height + "\" viewBox=\"0 0 " + width + " " + height +
      "\" font-family=\"Roboto, Helvetica, Arial, sans-serif\" font-size=\"" + length(font_size) +
      "\">\n<title>" + xml_text(figure.title) +
      "</title>\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
  if (head > 0)
    out += "<text x=\"" + length(margin) + "\" y=\"" + length(margin + 1.1f * font_size) + "\" font-size=\"" +
           length(1.25f * font_size) + "\" font-weight=\"bold\" fill=\"" + ink_colour(Ink::text, {}) + "\">" +
           xml_text(figure.title.substr(0, 200)) + "</text>\n";
  out += "<g transform=\"translate(" + length(margin) + " " + length(margin + head) + ")\">\n";
  for (const DrawnMark& mark : drawing.marks) std::visit(SvgWriter{out}, mark);
  for (const HoverValue& value : drawing.values) out += hover_mark(value);
  return out + "</g>\n</svg>\n";
}

std::string to_csv(const Figure& figure) {
  std::string out = "plot,series,x,y,note\n";
  for (const Plot& plot : figure.panels) {
    if (plot.matrix) {
      const PlotMatrix& matrix = *plot.matrix;
      for (std::size_t r = 0; r < matrix.rows.size(); ++r)
        for (std::size_t c = 0; c < matrix.columns.size(); ++c)
          if (const double value = matrix.values[r * matrix.columns.size() + c]; std::isfinite(value))
            add_line(out, plot.title, matrix.rows[r], matrix.columns[c], value, "");
      continue;
    }
    for (const PlotSeries& series : plot.series) add_lines(out, plot, series);
  }
  return out;
}

void write_figure(const std::filesystem::path& path, const Figure& figure) {
  if (path.extension() == ".svg")
    replace_file(path, to_svg(figure));
  else if (path.extension() == ".csv")
    replace_file(path, to_csv(figure));
  else
    throw InputError(path, "", "expected a name that ends with .svg or .csv");
}

}  // namespace archetype
