#include "core/report/report_sections.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "core/base/error.h"
#include "core/io/json_input.h"
#include "core/report/html_text.h"
#include "core/report/plot_catalog.h"
#include "core/report/report_pictures.h"
#include "core/report/template_svg.h"
#include "core/report/xml_text.h"
#include "core/session/cluster_size.h"
#include "core/session/fit_state.h"

namespace archetype {

namespace {

constexpr std::size_t most_members = 24;    // that a cluster shows
constexpr std::size_t most_pictures = 400;  // of the page
constexpr std::size_t most_worst = 20;
constexpr std::size_t least_worst = 5;
constexpr std::size_t most_listed = 200;
constexpr int picture_side = 160;

std::string count_of(std::size_t count, const std::string& thing) {
  return std::to_string(count) + ' ' + thing + (count == 1 ? "" : "s");
}

// A quarter of the shapes: the list of the worst is to point somewhere.
std::size_t worst_of(std::size_t shapes) {
  return std::min(shapes, std::clamp(shapes / 4, least_worst, most_worst));
}

std::string name_of(const ReportContent& content, ShapeId id) {
  const auto found = content.names.find(id);
  return found == content.names.end() ? "?" : found->second;
}

const PartTemplate* template_of(const ReportContent& content, TemplateId id) {
  const auto found = std::ranges::find(content.templates, id, &TemplateRecord::id);
  return found == content.templates.end() ? nullptr : &found->part_template;
}

std::string template_name(const ReportContent& content, TemplateId id) {
  const PartTemplate* part_template = template_of(content, id);
  return part_template ? part_template->name : "?";
}

// "" once the page has as many as it may, or where a stranger's project has none that can be shown.
std::string picture_of(ReportContent& content, ShapeId shape) {
  if (content.pictures >= most_pictures) return "";
  try {
    const Picture picture = report_picture(content.project, shape, picture_side, content.draw);
    ++content.pictures;
    return html_picture(picture, name_of(content, shape));
  } catch (const InputError&) {
    return "";
  }
}

std::string thumbnails(ReportContent& content, const std::vector<FitSummary>& fits) {
  std::string grid = "<div class=\"grid\">\n";
  for (std::size_t i = 0; i < fits.size() && i < most_members; ++i) {
    if (content.control.cancelled()) break;
    grid += "<div class=\"cell\">" + picture_of(content, fits[i].shape) +
            xml_text(name_of(content, fits[i].shape)) + "<br>" + fixed_text(fits[i].energy.total(), 3) +
            "</div>\n";
  }
  grid += "</div>\n";
  if (fits.size() > most_members)
    grid += html_paragraph("and " + count_of(fits.size() - most_members, "other"));
  return grid;
}

double energy_of(const FitSummary& fit) {
  return fit.energy.total();
}

std::string vector_text(const Vec3& v) {
  return fixed_text(v.x(), 2) + ", " + fixed_text(v.y(), 2) + ", " + fixed_text(v.z(), 2);
}

// "" where the sources have not what it needs.
std::string figure(const char* name, const PlotSources& sources) {
  const PlotEntry* entry = find_plot(name);
  return entry && has_what_it_needs(*entry, sources) ? html_figure(make_figure(*entry, sources)) : "";
}

}  // namespace

std::string collection_section(const ReportContent& content) {
  std::size_t labelled = 0;
  std::size_t outliers = 0;
  double energy = 0;
  for (const FitSummary& fit : content.fits) {
    labelled += fit.has_labels ? 1 : 0;
    outliers += fit.status == FitStatus::outlier ? 1 : 0;
    energy += energy_of(fit) / static_cast<double>(content.fits.size());
  }
  const auto number = [](std::size_t value) { return std::to_string(value); };
  return html_heading("Collection", "collection") +
         html_table({"", "#"}, {{"shapes", number(content.names.size())},
                                {"fitted", number(content.fits.size())},
                                {"with labels for every face", number(labelled)},
                                {"outliers", number(outliers)},
                                {"templates", number(content.templates.size())},
                                {"refused inputs", number(content.refused.size())},
                                {"mean energy", content.fits.empty() ? "-" : fixed_text(energy, 4)}});
}

std::string templates_section(const ReportContent& content) {
  std::string section = html_heading("Templates", "templates");
  if (content.templates.empty()) return section + html_paragraph("There is no template yet.");
  section +=
      "<p class=\"muted\">Mean boxes; an ellipse for one standard deviation of the position, dashed lines "
      "for that of the size; dashed boxes are parts that most of the shapes lack. Lengths in mean distances "
      "of a shape's points from its centre.</p>\n";
  for (const TemplateRecord& record : content.templates) {
    const PartTemplate& part_template = record.part_template;
    ClusterSize size;
    for (const FitSummary& fit : content.fits)
      if (fit.part_template == record.id) size.add(fit.status);
    section += "<h3>" + xml_text(part_template.name) + "</h3>\n<p class=\"muted\">" +
               count_of(part_template.parts.size(), "part") + ", " + to_string(size) +
               (record.current ? "" : ", no longer in use") + "</p>\n<div class=\"row\">";
    section += template_svg(part_template, 300);
    std::vector<std::vector<HtmlCell>> rows;
    for (std::size_t i = 0; i < part_template.parts.size() && i < most_listed; ++i) {
      const TemplatePart& part = part_template.parts[i];
      rows.push_back({html_swatch(part_colour(part_template, static_cast<int>(i))) + xml_text(part.name),
                      std::to_string(part.label), part.must_exist ? "yes" : "", percent_text(part.existence),
                      vector_text(part.position.mean), vector_text(part.scale.mean),
                      vector_text(part.scale.stddev)});
    }
    section +=
        html_table({"part", "#label", "must exist", "#exists", "#centre", "#half extents", "#spread"}, rows) +
        "</div>\n";
  }
  return section;
}

std::string clusters_section(ReportContent& content) {
  std::string section = html_heading("Clusters", "clusters");
  if (content.fits.empty()) return section + html_paragraph("No shape is fitted yet.");
  section +=
      "<p class=\"muted\">The shapes of each template, those that it explains best first, with the "
      "energies of their fits.</p>\n";
  std::vector<FitSummary> outliers;
  for (const TemplateRecord& record : content.templates) {
    std::vector<FitSummary> members;
    ClusterSize size;
    for (const FitSummary& fit : content.fits) {
      if (fit.part_template != record.id) continue;
      size.add(fit.status);
      (fit.status == FitStatus::outlier ? outliers : members).push_back(fit);
    }
    if (members.empty()) continue;
    std::ranges::stable_sort(members, {}, energy_of);
    section += "<h3>" + xml_text(record.part_template.name) + " (" + to_string(size) + ")</h3>\n" +
               thumbnails(content, members);
  }
  if (outliers.empty()) return section;
  std::ranges::stable_sort(outliers, std::greater<>(), energy_of);
  return section + "<h3>Outliers (" + std::to_string(outliers.size()) + "), worst first</h3>\n" +
         thumbnails(content, outliers);
}

std::string worst_fits_section(ReportContent& content) {
  std::string section = html_heading("Worst fits", "worst");
  if (content.fits.empty()) return section + html_paragraph("No shape is fitted yet.");
  std::vector<FitSummary> fits = content.fits;
  std::ranges::stable_sort(fits, std::greater<>(), energy_of);
  std::vector<std::vector<HtmlCell>> rows;
  for (std::size_t i = 0; i < worst_of(fits.size()) && !content.control.cancelled(); ++i) {
    const FitEnergy& energy = fits[i].energy;
    rows.push_back({picture_of(content, fits[i].shape), xml_text(name_of(content, fits[i].shape)),
                    xml_text(template_name(content, fits[i].part_template)),
                    std::string(to_string(fits[i].status)), fixed_text(energy.total(), 3),
                    fixed_text(energy.data(), 3), fixed_text(energy.deformation, 3),
                    fixed_text(energy.smoothness, 3), fixed_text(energy.existence, 3)});
  }
  return section + html_table({"", "shape", "template", "status", "#energy", "#distances and features",
                               "#deformation", "#smoothness", "#parts"},
                              rows);
}

std::string accuracy_section(const LabellingEvaluation& evaluation) {
  const LabellingReport& report = evaluation.report;
  std::string section = html_heading("Accuracy", "accuracy");
  if (report.shapes.empty())
    return section + html_paragraph("No fitted shape has a file of true labels in the folder given.");
  section += html_paragraph(
      "Share of the surface, and of the faces, with the right label: with the templates' "
      "own labels, and with the best assignment of parts to labels over the collection.");
  const auto row = [](const std::string& name, const ShapeAccuracy& accuracy) {
    return std::vector<HtmlCell>{name, percent_text(accuracy.own.by_area),
                                 percent_text(accuracy.own.by_count), percent_text(accuracy.best.by_area),
                                 percent_text(accuracy.best.by_count)};
  };
  const std::vector<std::string> head{"", "#own, by area", "#own, by faces", "#best, by area",
                                      "#best, by faces"};
  section += html_table(head, {row("mean over " + count_of(report.shapes.size(), "shape"), report.mean),
                               row("all faces together", report.total)});
  std::vector<ShapeAccuracy> shapes = report.shapes;
  std::ranges::stable_sort(shapes, {}, [](const ShapeAccuracy& s) { return s.own.by_area; });
  std::vector<std::vector<HtmlCell>> rows;
  for (std::size_t i = 0; i < worst_of(shapes.size()); ++i)
    rows.push_back(row(xml_text(shapes[i].name), shapes[i]));
  PlotSources sources;
  sources.labelling = &evaluation;
  section += figure("accuracy-by-label", sources) + figure("confusion", sources);
  section += "<h3>Worst shapes</h3>\n" + html_table(head, rows);
  rows.clear();
  const auto label_text = [&](int label) {
    const auto i = static_cast<std::size_t>(label);
    const bool named = label >= 0 && i < evaluation.label_names.size();
    std::string text = std::to_string(label);
    if (named) text.append(" ").append(xml_text(evaluation.label_names[i]));
    return text;
  };
  for (std::size_t i = 0; i < evaluation.parts.size() && i < most_listed; ++i) {
    const EvaluatedPart& part = evaluation.parts[i];
    if (report.best_labels[i] < 0) continue;  // nothing lies in it
    rows.push_back({xml_text(part.part_template), xml_text(part.part), label_text(part.label),
                    label_text(report.best_labels[i])});
  }
  section += "<h3>What the parts stand for</h3>\n" +
             html_table({"template", "part", "own label", "label that it overlaps most"}, rows);
  const std::size_t missing = evaluation.without_truth.size() + evaluation.without_labels.size();
  if (missing > 0)
    section += html_paragraph(count_of(missing, "shape") + " without true labels, fit or file left out.");
  return section;
}

std::string learning_section(const ReportContent& content) {
  if (!content.learning || content.learning->steps.empty()) return "";
  const LearningRecord& learning = *content.learning;
  std::string section = html_heading("Learning", "learning");
  section += html_paragraph("Began with " + count_of(learning.start.size(), "template") + ", judged by " +
                            count_of(learning.judging.size(), "shape") +
                            (learning.settled ? "; the last round kept nothing new." : "; not settled yet."));
  std::vector<std::vector<HtmlCell>> rows;
  for (const LearningStep& step : learning.steps)
    rows.push_back({std::to_string(step.iteration), std::to_string(step.templates.size()),
                    fixed_text(step.energy_before, 4), fixed_text(step.energy, 4)});
  section += html_table({"#round", "#templates", "#energy before", "#energy after"}, rows);
  PlotSources sources;
  sources.learning = &learning;
  return section + figure("learning-energy", sources) + figure("learning-templates", sources);
}

std::string settings_section(const ReportContent& content) {
  std::vector<std::vector<HtmlCell>> rows{{"program", "archetype " ARCHETYPE_VERSION}};
  std::set<std::string> ways;
  for (const ShapeRecord& shape : content.project.shapes())
    ways.insert(std::to_string(shape.requested_points) + " points, seed " + std::to_string(shape.seed) +
                ", up " + std::string(to_string(shape.up)));
  for (const std::string& way : ways) rows.push_back({"samples", way});
  if (const auto text = content.project.setting(fit_options_setting)) {
    try {
      const nlohmann::json options = parse_json(*text, content.project.path());
      for (const auto& [name, value] : options.items())
        if (rows.size() < most_listed)
          rows.push_back({xml_text(name),
                          xml_text(value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace))});
    } catch (const InputError&) {
      // A project from elsewhere may hold anything there.
    }
  }
  return html_heading("Settings", "settings") + html_table({"", ""}, rows);
}

std::string refused_section(const ReportContent& content) {
  if (content.refused.empty()) return "";
  std::vector<std::vector<HtmlCell>> rows;
  for (std::size_t i = 0; i < content.refused.size() && i < most_listed; ++i)
    rows.push_back({xml_text(content.refused[i].path.string()), xml_text(content.refused[i].reason)});
  std::string section = html_heading("Refused inputs", "refused") + html_table({"file", "reason"}, rows);
  if (content.refused.size() > most_listed)
    section += html_paragraph("and " + count_of(content.refused.size() - most_listed, "other"));
  return section;
}

}  // namespace archetype
