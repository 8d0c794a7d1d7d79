// Pieces of the report's page: nothing of a stranger's text gets into it unescaped.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/picture.h"
#include "core/model/part_colours.h"
#include "core/report/plot.h"

namespace archetype {

// A cell of a table: its markup is ready, what strangers wrote in it escaped.
using HtmlCell = std::string;

std::string html_heading(std::string_view title, std::string_view anchor);
std::string html_paragraph(std::string_view text);
// Columns whose head begins with "#" hold numbers and stand to the right.
std::string html_table(const std::vector<std::string>& head, const std::vector<std::vector<HtmlCell>>& rows);
// The picture inside of the page, as it is: no file beside it is needed.
std::string html_picture(const Picture& picture, std::string_view alternative);
// A plot inside of the page.
std::string html_figure(const Figure& figure);
std::string html_swatch(const Rgb& colour);
std::string fixed_text(double value, int decimals);  // "0.125"; "-" for what is not finite
std::string percent_text(double share);              // "12.5 %"

// The page around the sections: its look, and a rule that forbids it to load anything.
std::string html_page(std::string_view title, std::string_view body);

}  // namespace archetype
