// Reads what the sections need, and puts them on the page.
#include "core/report/html_report.h"

#include <algorithm>

#include "core/report/html_text.h"
#include "core/report/report_sections.h"
#include "core/report/xml_text.h"

namespace archetype {

namespace {

ReportContent read_content(const Project& project, const DrawShape& draw, const JobControl& control) {
  ReportContent content{project,           project.templates(),      project.fits(), {},
                        project.refused(), learning_record(project), control,        draw};
  for (const ShapeRecord& shape : project.shapes()) content.names[shape.id] = shape.name;
  for (const FitSummary& fit : content.fits) {
    const bool known = std::ranges::any_of(
        content.templates, [&](const auto& record) { return record.id == fit.part_template; });
    if (known) continue;
    if (auto older = project.find_template(fit.part_template)) content.templates.push_back(std::move(*older));
  }
  return content;
}

std::string navigation(const std::string& body) {
  std::string links = "<nav>";
  const std::string mark = "<h2 id=\"";
  for (std::size_t at = body.find(mark); at != std::string::npos; at = body.find(mark, at + 1)) {
    const std::size_t anchor = at + mark.size();
    const std::size_t end = body.find('"', anchor);
    const std::size_t title = end + 2;
    links += "<a href=\"#" + body.substr(anchor, end - anchor) + "\">" +
             body.substr(title, body.find("</h2>", title) - title) + "</a>";
  }
  return links + "</nav>\n";
}

}  // namespace

std::optional<HtmlReport> html_report(const Project& project, const ReportOptions& options,
                                      const JobControl& control) {
  ReportContent content = read_content(project, options.draw, control);
  const std::size_t steps = options.labels.empty() ? 2 : 3;
  control.progress(0, steps, "writing the report");
  std::string body = collection_section(content) + templates_section(content) + clusters_section(content);
  control.progress(1, steps, "writing the report");
  body += worst_fits_section(content);
  control.progress(2, steps, "writing the report");
  if (control.cancelled()) return std::nullopt;
  if (!options.labels.empty()) {
    JobControl evaluating;
    evaluating.stop = control.stop;
    const LabellingEvaluation evaluation =
        evaluate_labelling(project, options.labels, options.threads, evaluating);
    if (evaluation.cancelled) return std::nullopt;
    body += accuracy_section(evaluation);
  }
  body += learning_section(content) + settings_section(content) + refused_section(content);
  const std::string title = options.title.empty() ? project.path().stem().string() : options.title;
  const std::string head =
      "<h1>" + xml_text(title) + "</h1>\n<p class=\"muted\">Parts, templates and fits of " +
      std::to_string(content.names.size()) + " shapes, found by Archetype " + ARCHETYPE_VERSION + "</p>\n";
  return HtmlReport{html_page(title, head + navigation(body) + body), content.names.size(), content.pictures};
}

}  // namespace archetype
