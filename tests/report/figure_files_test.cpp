// Figures as files: SVG that is XML whatever names are in it, CSV that reads back as what was written.
#include "core/report/figure_files.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/io/file.h"
#include "core/report/axis_marks.h"
#include "core/report/plot_drawing.h"
#include "core/report/xml_text.h"
#include "tests/report/made_reports.h"
#include "tests/support/scratch_folder.h"

using namespace archetype;
using namespace archetype::test;

namespace {

// Whether every tag is closed in order and every attribute is quoted: all that we write of XML.
bool well_formed(const std::string& text) {
  std::vector<std::string> open;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto c = static_cast<unsigned char>(text[i]);
    if (c < 0x20 && c != '\n' && c != '\t' && c != '\r') return false;
    if (text[i] == '>') return false;
    if (text[i] == '&' && text.find(';', i) > i + 6) return false;
    if (text[i] != '<') continue;
    std::size_t end = i;
    bool quoted = false;
    while (++end < text.size() && (quoted || text[end] != '>')) {
      if (text[end] == '"') quoted = !quoted;
      if (text[end] == '<') return false;
    }
    if (end >= text.size()) return false;
    const std::string tag = text.substr(i + 1, end - i - 1);
    const std::string name = tag.substr(0, tag.find_first_of(" \n"));
    if (name[0] == '/') {
      if (open.empty() || open.back() != name.substr(1)) return false;
      open.pop_back();
    } else if (name[0] != '?' && tag.back() != '/') {
      open.push_back(name);
    }
    i = end;
  }
  return open.empty();
}

// RFC 4180.
std::vector<std::vector<std::string>> read_csv(const std::string& text) {
  std::vector<std::vector<std::string>> lines(1, {""});
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted && c == '"' && i + 1 < text.size() && text[i + 1] == '"') {
      lines.back().back() += text[++i];
    } else if (c == '"') {
      quoted = !quoted;
    } else if (!quoted && c == ',') {
      lines.back().emplace_back();
    } else if (!quoted && c == '\n') {
      lines.push_back({""});
    } else {
      lines.back().back() += c;
    }
  }
  lines.pop_back();
  return lines;
}

Plot curve_plot(const std::string& name) {
  Plot plot;
  plot.title = name;
  plot.x.label = name;
  plot.series.push_back(
      {.name = name, .x = {0, 0.1, 0.3}, .y = {1.0 / 3, -2.5e-7, 4}, .notes = {name, "", "b"}});
  return plot;
}

std::size_t count_of(const std::string& text, const std::string& what) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++count;
  return count;
}

PlotSpace space_of(float width, float height) {
  PlotSpace space;
  space.width = width;
  space.height = height;
  space.text_width = [](const std::string& text, TextKind) { return 7 * static_cast<float>(text.size()); };
  return space;
}

}  // namespace

TEST_CASE("texts of strangers are escaped, and what is no character is replaced") {
  CHECK(xml_text("a<b>&\"c'") == "a&lt;b&gt;&amp;&quot;c&#39;");
  CHECK(xml_text("Ω ü 椅 😀") == "Ω ü 椅 😀");
  CHECK(xml_text("a\xff\xc3") == "a\xEF\xBF\xBD\xEF\xBF\xBD");
  CHECK(xml_text(std::string_view("\x00\x1b", 2)) == "\xEF\xBF\xBD\xEF\xBF\xBD");
  CHECK(xml_text("\xed\xa0\x80").find("\xed\xa0") == std::string::npos);  // half a surrogate pair
  CHECK(xml_text("\xc0\xaf") == "\xEF\xBF\xBD\xEF\xBF\xBD");              // "/" written too long
}

TEST_CASE("every plot is well-formed SVG and readable CSV, whatever its names") {
  const FitTable fits = made_fits(40, hostile_name);
  const LearningRecord learning = made_record(hostile_name);
  const LabellingEvaluation labelling = made_labelling(hostile_name);
  const LandmarkEvaluation landmarks = made_landmarks(hostile_name);
  const std::vector<SubsetMeasure> subsets{{8, 1, 0.5, 0.25}, {16, 2, 0.75, 0.5}};
  std::vector<StartMeasure> starts(2);
  for (StartMeasure& start : starts) start.initial.name = hostile_name;
  const PlotSources sources{&fits, &learning, &labelling, &landmarks, subsets, starts, 0, 1};
  for (const PlotEntry& entry : plot_catalog()) {
    CAPTURE(std::string(entry.name));
    REQUIRE(has_what_it_needs(entry, sources));
    const Figure figure = make_figure(entry, sources);
    CHECK(figure.name == entry.name);
    const std::string svg = to_svg(figure);
    CHECK(well_formed(svg));
    CHECK(svg.find("<script") == std::string::npos);
    CHECK(count_of(svg, "<text") > 5);
    const auto lines = read_csv(to_csv(figure));
    CHECK(lines.size() > 1);
    for (const auto& line : lines) CHECK(line.size() == 5);
  }
  CHECK_FALSE(well_formed("<a><b></a></b>"));
  CHECK_FALSE(well_formed("<a>x & y</a>"));
}

TEST_CASE("values of a CSV read back as they were, with the names they belong to") {
  Figure figure;
  figure.panels.push_back(curve_plot(hostile_name));
  const auto lines = read_csv(to_csv(figure));
  REQUIRE(lines.size() == 4);
  CHECK(lines[0] == std::vector<std::string>{"plot", "series", "x", "y", "note"});
  CHECK(lines[1] == std::vector<std::string>{hostile_name, hostile_name, "0", lines[1][3], hostile_name});
  CHECK(std::stod(lines[1][3]) == 1.0 / 3);
  CHECK(std::stod(lines[2][3]) == -2.5e-7);
  CHECK(lines[3][2] == "0.3");

  Plot bars;
  bars.categories = {"a,b", "c"};
  bars.series.push_back({.kind = SeriesKind::bars, .x = {0, 1, 7}, .y = {1, NAN, 3}});
  Plot matrix;
  matrix.matrix = PlotMatrix{"r", "c", {"r1", "r2"}, {"c1", "c2"}, {0.1, 0.2, 0.3, 0.4}};
  figure.panels = {bars, matrix};
  const auto more = read_csv(to_csv(figure));
  REQUIRE(more.size() == 6);
  CHECK(more[1] == std::vector<std::string>{"", "", "a,b", "1", ""});
  CHECK(more[4] == std::vector<std::string>{"", "r2", "c1", "0.3", ""});
}

TEST_CASE("files are written by their ending") {
  const ScratchFolder folder;
  Figure figure;
  figure.panels.push_back(curve_plot("a"));
  write_figure(folder.path() / "a.svg", figure);
  write_figure(folder.path() / "a.csv", figure);
  CHECK(read_file(folder.path() / "a.svg") == to_svg(figure));
  CHECK(read_file(folder.path() / "a.csv") == to_csv(figure));
  CHECK_THROWS_AS(write_figure(folder.path() / "a.png", figure), InputError);
  CHECK_THROWS_AS(write_figure(folder.path() / "none" / "a.svg", figure), FileError);
}

TEST_CASE("plots of nothing, of one value and of values that cannot be shown do no harm") {
  const double huge = std::numeric_limits<double>::max();
  const double infinite = std::numeric_limits<double>::infinity();
  const std::vector<std::vector<double>> values{
      {}, {0}, {5}, {NAN}, {infinite, -infinite}, {-huge, huge}, {1e-300, 0}, {3, 3, 3}};
  for (const SeriesKind kind :
       {SeriesKind::line, SeriesKind::dots, SeriesKind::line_and_dots, SeriesKind::bars}) {
    for (const auto& y : values) {
      for (const bool named : {false, true}) {
        Plot plot;
        PlotSeries series{.kind = kind, .y = y};
        for (std::size_t i = 0; i < y.size(); ++i) series.x.push_back(static_cast<double>(i));
        plot.series = {series};
        if (named) plot.categories = {"one", "two", "three"};
        for (const float side : {1.0f, 60.0f, 900.0f}) {
          const PlotDrawing drawing = draw_plot(plot, space_of(side, side));
          for (const HoverValue& value : drawing.values) {
            CHECK(std::isfinite(value.low.x));
            CHECK(value.high.y <= side * 1.5f + 20);
          }
        }
        CHECK(well_formed(to_svg({.panels = {plot}})));
      }
    }
  }
  CHECK(well_formed(to_svg({})));
  CHECK(to_csv({}) == "plot,series,x,y,note\n");
}

TEST_CASE("what is under the mouse is the nearest value; what lies within the axes is inside the picture") {
  const Plot plot = curve_plot("curve");
  const PlotDrawing drawing = draw_plot(plot, space_of(600, 400));
  REQUIRE(drawing.values.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    const HoverValue& value = drawing.values[i];
    const float x = (value.low.x + value.high.x) / 2;
    const float y = (value.low.y + value.high.y) / 2;
    CHECK(value_at(drawing, x + 2, y) == i);
    CHECK(x >= 0);
    CHECK(x <= 600);
    CHECK(y >= 0);
    CHECK(y <= 400);
  }
  CHECK(drawing.values[2].text.find("4") != std::string::npos);
  CHECK(drawing.values[2].text.find("b") != std::string::npos);
  CHECK_FALSE(value_at(drawing, -100, -100));
}

TEST_CASE("a figure of many rows gets higher rather than unreadable, and panels do not overlap") {
  Plot plot;
  for (int i = 0; i < 200; ++i) plot.categories.push_back("part " + std::to_string(i));
  PlotSeries series{.kind = SeriesKind::bars};
  for (int i = 0; i < 200; ++i) {
    series.x.push_back(i);
    series.y.push_back(i);
  }
  plot.series = {series};
  Figure figure{.panels = {plot, curve_plot("next")}, .columns = 1};
  const PlotDrawing drawing = draw_figure(figure, space_of(600, 400));
  CHECK(drawing.height > 200 * 16);
  float bottom = 0;
  for (std::size_t i = 0; i < 200; ++i) bottom = std::max(bottom, drawing.values[i].high.y);
  for (std::size_t i = 200; i < drawing.values.size(); ++i) CHECK(drawing.values[i].low.y > bottom);
}

TEST_CASE("Marks of an axis are round numbers that enclose the values") {
  CHECK(axis_marks(0.13, 0.87, 6) == std::vector<double>{0, 0.2, 0.4, 0.6000000000000001, 0.8, 1});
  const std::vector<std::pair<double, double>> ranges{{0.1, 0.10001}, {5.0, 5.0},   {0.0, 0.0},
                                                      {-3.0, 1e6},    {1e-9, 2e-9}, {-1e100, 1e100}};
  for (const auto& [low, high] : ranges) {
    CAPTURE(low);
    CAPTURE(high);
    for (const std::size_t most : {3, 5, 9}) {
      const std::vector<double> marks = axis_marks(low, high, most);
      REQUIRE(marks.size() >= 2);
      CHECK(marks.size() <= most);
      CHECK(marks.front() <= low + 1e-9 * std::abs(low));
      CHECK(marks.back() >= high - 1e-9 * std::abs(high));
    }
  }
  CHECK(mark_text(0.6000000000000001, 0.2) == "0.6");
  CHECK(mark_text(-1e-17, 0.5) == "0.0");
  CHECK(mark_text(20, 10) == "20");
}
