#include "core/report/html_text.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "core/io/png.h"
#include "core/report/figure_files.h"
#include "core/report/xml_text.h"

namespace archetype {
namespace {

constexpr const char* style = R"css(
:root{--ink:#1c1e22;--muted:#667;--line:#dde1e6;--back:#fff;--raised:#f5f6f8}
body{font:15px/1.5 Roboto,"Segoe UI",Helvetica,Arial,sans-serif;color:var(--ink);background:var(--back);
max-width:1100px;margin:0 auto;padding:24px 28px 60px}
h1{font-size:28px;margin:0 0 4px;overflow-wrap:anywhere}h2{font-size:20px;margin:40px 0 10px;padding-top:12px;
border-top:1px solid var(--line)}h3{font-size:16px;margin:24px 0 8px;overflow-wrap:anywhere}
p{margin:6px 0 12px}.muted{color:var(--muted)}nav a{margin-right:14px}a{color:#2366b8}
table{border-collapse:collapse;margin:8px 0 16px;font-size:14px;max-width:100%}
th,td{padding:4px 12px 4px 0;text-align:left;vertical-align:middle;border-bottom:1px solid var(--line);
overflow-wrap:anywhere}th{font-weight:600;color:var(--muted)}th.n,td.n{text-align:right;
font-variant-numeric:tabular-nums;white-space:nowrap}
.swatch{display:inline-block;width:12px;height:12px;border-radius:3px;margin-right:7px;vertical-align:-1px}
.grid{display:grid;grid-template-columns:repeat(auto-fill,minmax(112px,1fr));gap:10px;margin:8px 0 16px}
.cell{background:var(--raised);border-radius:8px;padding:4px;text-align:center;font-size:12px;
color:var(--muted);overflow-wrap:anywhere}.cell img{width:100%;max-width:160px;display:block;margin:0 auto}
.row{display:flex;gap:24px;align-items:flex-start;flex-wrap:wrap}.row>svg{flex:0 0 300px}
td img{width:72px;height:72px}
svg.plot{max-width:100%;height:auto}
@media print{body{padding:0}h2{break-after:avoid}.row,.cell{break-inside:avoid}}
)css";

constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

std::string base64(std::string_view bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned triple = 0;
    for (std::size_t k = 0; k < 3; ++k)
      triple = triple << 8U | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k > bytes.size() ? '=' : letters[triple >> (18 - 6 * k) & 0x3fU];
  }
  return text;
}

bool is_number(const std::string& head) {
  return head.starts_with('#');
}

}  // namespace

std::string html_heading(std::string_view title, std::string_view anchor) {
  return "<h2 id=\"" + xml_text(anchor) + "\">" + xml_text(title) + "</h2>\n";
}

std::string html_paragraph(std::string_view text) {
  return "<p>" + xml_text(text) + "</p>\n";
}

std::string html_table(const std::vector<std::string>& head, const std::vector<std::vector<HtmlCell>>& rows) {
  std::string table = "<table><thead><tr>";
  for (const std::string& title : head)
    table += is_number(title) ? "<th class=\"n\">" + xml_text(title.substr(1)) + "</th>"
                              : "<th>" + xml_text(title) + "</th>";
  table += "</tr></thead><tbody>\n";
  for (const std::vector<HtmlCell>& row : rows) {
    table += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i)
      table += (i < head.size() && is_number(head[i]) ? "<td class=\"n\">" : "<td>") + row[i] + "</td>";
    table += "</tr>\n";
  }
  return table + "</tbody></table>\n";
}

std::string html_picture(const Picture& picture, std::string_view alternative) {
  return "<img alt=\"" + xml_text(alternative) + "\" src=\"data:image/png;base64," +
         base64(encode_png(picture)) + "\">";
}

std::string html_figure(const Figure& figure) {
  std::string svg = to_svg(figure, {.width = 720, .height = 380});
  svg.erase(0, svg.find("<svg"));  // what stands before it belongs to a file of its own
  return svg.insert(4, " class=\"plot\"") + "\n";
}

std::string html_swatch(const Rgb& colour) {
  std::array<char, 8> hex{};
  std::snprintf(hex.data(), hex.size(), "#%02x%02x%02x", colour[0], colour[1], colour[2]);
  return "<span class=\"swatch\" style=\"background:" + std::string(hex.data()) + "\"></span>";
}

std::string fixed_text(double value, int decimals) {
  if (!std::isfinite(value)) return "-";
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), std::abs(value) < 1e12 ? "%.*f" : "%.*g", decimals, value);
  const std::string_view written(text.data());
  const bool nothing = written.starts_with('-') && written.find_first_not_of("-0.") == std::string_view::npos;
  return std::string(nothing ? written.substr(1) : written);
}

std::string percent_text(double share) {
  return fixed_text(100 * share, 1) + " %";
}

std::string html_page(std::string_view title, std::string_view body) {
  std::string page =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; style-src "
      "'unsafe-inline'\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>";
  page += xml_text(title);
  page += "</title>\n<style>";
  page += style;
  page += "</style></head><body>\n";
  page += body;
  return page + "</body></html>\n";
}

}  // namespace archetype
