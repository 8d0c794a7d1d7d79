// Figures and the report: made by jobs, so that the window goes on, and a script without a display can make
// them.
#include "core/base/error.h"
#include "core/io/file.h"
#include "core/report/html_report.h"
#include "render/picture_file.h"
#include "ui/cloud_view.h"
#include "ui/command_groups.h"
#include "ui/figure.h"
#include "ui/file_browser.h"
#include "ui/studio.h"

namespace archetype {
namespace {

using MakeFigure = std::optional<Picture> (*)(const FigureRequest&, const JobControl&);

void want_nothing_more(const Studio&, FigureRequest&) {}

// What the view of the clouds shows, whether or not it is in sight.
void want_cloud(const Studio& studio, FigureRequest& request) {
  const CloudChoice& cloud = studio.ui.cloud;
  CloudShapes wanted = wanted_shapes(studio);
  request.shapes = std::move(wanted.shapes);
  request.outliers = wanted.outliers;
  request.cloud_colour = cloud.colour;
  if (cloud.scope == CloudScope::collection) request.cloud_of = studio.collection.title;
  if (cloud.scope == CloudScope::selection) request.cloud_of = "Selected shapes";
}

void want_shape_in_view(const Studio& studio, FigureRequest& request) {
  if (studio.ui.shape) request.shapes = {*studio.ui.shape};
}

// FILE [WIDTH] [transparent]
FigureOptions figure_options(Arguments arguments) {
  FigureOptions options;
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    if (arguments[i] == "transparent") {
      options.transparent = true;
      continue;
    }
    const double width = number_argument(arguments, i, "a width in pixels, or transparent");
    check_figure_width(width);
    options.width = static_cast<int>(width);
  }
  return options;
}

template <MakeFigure make, void (*want)(const Studio&, FigureRequest&) = want_nothing_more>
void figure(Studio& studio, Arguments arguments, const char* command, const char* title) {
  if (arguments.empty()) {
    browse(studio, {.command = command,
                    .title = title,
                    .saving = true,
                    .figure = true,
                    .ending = ".png",
                    .proposed = std::string(command).substr(std::string_view("figure-").size()) + ".png"});
    return;
  }
  std::filesystem::path file = arguments[0];
  if (file.empty()) throw Error("expected a file");
  FigureRequest request;
  request.project = studio.collection.path;
  request.shaders = studio.options.shaders;
  request.options = figure_options(arguments);
  want(studio, request);
  for (const auto& part_template : studio.history.committed().templates)
    request.templates.push_back(*part_template);
  studio.jobs.start("Figure " + file.filename().string(),
                    [&studio, file, request = std::move(request)](const JobControl& control) -> Jobs::Apply {
                      const std::optional<Picture> picture = make(request, control);
                      if (!picture) return {};
                      write_png(file, *picture);
                      return [&studio, file] {
                        say(studio, Severity::note, "Figure saved as " + file.string());
                      };
                    });
}

void templates_command(Studio& studio, Arguments arguments) {
  figure<templates_figure>(studio, arguments, "figure-templates", "Figure of the templates");
}
void clusters_command(Studio& studio, Arguments arguments) {
  figure<clusters_figure>(studio, arguments, "figure-clusters", "Figure of the clusters");
}
void members_command(Studio& studio, Arguments arguments) {
  figure<members_figure>(studio, arguments, "figure-members", "Figure of the clusters with all members");
}
void starts_command(Studio& studio, Arguments arguments) {
  figure<starts_figure>(studio, arguments, "figure-starts", "Figure of several starts");
}
void coalignment_command(Studio& studio, Arguments arguments) {
  figure<coalignment_figure, want_cloud>(studio, arguments, "figure-coalignment",
                                         "Figure of the co-aligned points");
}
void fit_command(Studio& studio, Arguments arguments) {
  figure<fit_figure, want_shape_in_view>(studio, arguments, "figure-fit", "Figure of the fit in view");
}

// FILE [LABELS_DIR]
void report_command(Studio& studio, Arguments arguments) {
  if (arguments.empty()) {
    browse(studio, {.command = "export-report",
                    .title = "Report as a page for a browser",
                    .saving = true,
                    .ending = ".html",
                    .proposed = "report.html"});
    return;
  }
  const std::filesystem::path file = arguments[0];
  if (file.empty()) throw Error("expected a file");
  ReportOptions options;
  options.title = studio.collection.title;
  options.threads = static_cast<unsigned>(studio.settings.threads);
  if (arguments.size() > 1) options.labels = text_argument(arguments, 1, "a folder of labels");
  const std::filesystem::path shaders = studio.options.shaders;
  studio.jobs.start("Report " + file.filename().string(),
                    [&studio, file, options, shaders,
                     path = studio.collection.path](const JobControl& control) mutable -> Jobs::Apply {
                      options.draw = thumbnail_drawer(path, shaders);
                      const auto report = html_report(Project::open(path), options, control);
                      if (!report) return {};
                      replace_file(file, report->page);
                      return [&studio, file] {
                        say(studio, Severity::note, "Report saved as " + file.string());
                      };
                    });
}

std::string needs_starts(const Studio& studio) {
  if (std::string reason = needs_collection(studio); !reason.empty()) return reason;
  return studio.collection.content.starts ? "" : "\"Learn from several starts\" first";
}

constexpr std::string_view figure_arguments = "[FILE.png [WIDTH] [transparent]]";

}  // namespace

void add_figure_commands(std::vector<Command>& commands) {
  commands.insert(commands.end(), {
                                      {.name = "figure-templates",
                                       .title = "Figure of the templates…",
                                       .menu = "File",
                                       .arguments = figure_arguments,
                                       .run = templates_command,
                                       .why_not = needs_collection,
                                       .separator = true},
                                      {.name = "figure-clusters",
                                       .title = "Figure of the clusters…",
                                       .menu = "File",
                                       .arguments = figure_arguments,
                                       .run = clusters_command,
                                       .why_not = needs_collection},
                                      {.name = "figure-members",
                                       .title = "Figure of the clusters with all members…",
                                       .menu = "File",
                                       .arguments = figure_arguments,
                                       .run = members_command,
                                       .why_not = needs_collection},
                                      {.name = "figure-starts",
                                       .title = "Figure of several starts…",
                                       .menu = "File",
                                       .arguments = figure_arguments,
                                       .run = starts_command,
                                       .why_not = needs_starts},
                                      {.name = "figure-coalignment",
                                       .title = "Figure of the co-aligned points…",
                                       .menu = "File",
                                       .arguments = figure_arguments,
                                       .run = coalignment_command,
                                       .why_not = needs_collection},
                                      {.name = "figure-fit",
                                       .title = "Figure of the fit in view…",
                                       .menu = "File",
                                       .arguments = figure_arguments,
                                       .run = fit_command,
                                       .why_not = needs_shape},
                                      {.name = "export-report",
                                       .title = "Report as a page for a browser…",
                                       .menu = "File",
                                       .arguments = "[FILE.html [LABELS_FOLDER]]",
                                       .run = report_command,
                                       .why_not = needs_collection},
                                  });
}

}  // namespace archetype
