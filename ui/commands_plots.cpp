// The centre views of the map and of plots, and what they are made of.
#include <algorithm>

#include "core/base/error.h"
#include "core/report/figure_files.h"
#include "ui/command_groups.h"
#include "ui/file_browser.h"
#include "ui/plot_sources.h"
#include "ui/project_actions.h"
#include "ui/shape_map_view.h"
#include "ui/studio.h"
#include "ui/switch_setting.h"

namespace archetype {
namespace {

template <CentreView view>
void show(Studio& studio, Arguments) {
  studio.ui.centre = view;
}

template <CentreView view>
bool is_shown(const Studio& studio) {
  return studio.ui.centre == view;
}

std::string needs_figure(const Studio& studio) {
  return studio.ui.plots.figure ? "" : "choose a plot that is there in the view Plots first";
}

// Learning and fitting change what would be compared.
std::string needs_fits_at_rest(const Studio& studio) {
  if (std::string reason = needs_collection(studio); !reason.empty()) return reason;
  const auto& rows = studio.collection.rows();
  if (std::ranges::none_of(rows, [](const ShapeRow& row) { return row.fit.has_value(); }))
    return "fit a template to all shapes first";
  return is_fitted(studio, studio.collection.path) ? "wait until all shapes are fitted" : "";
}

void show_plot(Studio& studio, Arguments arguments) {
  const std::string name = text_argument(arguments, 0, "the name of a plot");
  if (!find_plot(name)) throw Error("there is no plot \"" + name + "\"; `archetype help plot` lists them");
  studio.ui.centre = CentreView::plots;
  studio.settings.plot = name;
}

// Written at once: a few hundred kilobytes at most.
template <const char* command, const char* ending>
void save_plot(Studio& studio, Arguments arguments) {
  if (arguments.empty()) {
    browse(studio, {.command = command,
                    .title = "Save the plot as",
                    .saving = true,
                    .ending = ending,
                    .proposed = studio.ui.plots.figure->name + ending});
    return;
  }
  std::filesystem::path path = text_argument(arguments, 0, "a file");
  if (path.extension() != ending) path += ending;
  write_figure(path, *studio.ui.plots.figure);
  say(studio, Severity::note, "Saved " + path.string());
}
constexpr char save_svg[] = "save-plot-svg";
constexpr char save_csv[] = "save-plot-csv";
constexpr char svg[] = ".svg";
constexpr char csv[] = ".csv";

void evaluate_labels_command(Studio& studio, Arguments arguments) {
  if (arguments.empty())
    browse(studio,
           {.command = "evaluate-labels", .title = "The folder of true labels", .folders_only = true});
  else
    evaluate_labels(studio, text_argument(arguments, 0, "a folder"));
}

void evaluate_landmarks_command(Studio& studio, Arguments arguments) {
  if (arguments.empty())
    browse(studio,
           {.command = "evaluate-landmarks", .title = "The folder of landmarks", .folders_only = true});
  else
    evaluate_marks(studio, text_argument(arguments, 0, "a folder"));
}

template <MapTool tool>
void take_map_tool(Studio& studio, Arguments) {
  studio.settings.map_tool = tool == MapTool::lasso ? "lasso" : "rectangle";
}

template <MapTool tool>
bool has_map_tool(const Studio& studio) {
  return studio.ui.map.tool == tool;
}

}  // namespace

void add_plot_commands(std::vector<Command>& commands) {
  commands.insert(commands.end(),
                  {
                      {.name = "show-map",
                       .title = "Map of the collection",
                       .menu = "View",
                       .key = "Alt+5",
                       .run = show<CentreView::map>,
                       .checked = is_shown<CentreView::map>},
                      {.name = "show-plots",
                       .title = "Plots",
                       .menu = "View",
                       .key = "Alt+6",
                       .run = show<CentreView::plots>,
                       .checked = is_shown<CentreView::plots>},
                      {.name = "show-plot", .title = "Show a plot", .arguments = "NAME", .run = show_plot},
                      {.name = "map-rectangle",
                       .title = "Select on the map by a rectangle",
                       .run = take_map_tool<MapTool::rectangle>,
                       .checked = has_map_tool<MapTool::rectangle>},
                      {.name = "map-lasso",
                       .title = "Select on the map by a lasso",
                       .run = take_map_tool<MapTool::lasso>,
                       .checked = has_map_tool<MapTool::lasso>},
                      {.name = "map-pictures",
                       .title = "Pictures on the map",
                       .run = toggle_setting<&Settings::map_pictures>,
                       .checked = setting_is_on<&Settings::map_pictures>},
                      {.name = "map-sliders",
                       .title = "Sliders that find shapes",
                       .run = toggle_setting<&Settings::map_sliders>,
                       .checked = setting_is_on<&Settings::map_sliders>},
                      {.name = "wish",
                       .title = "Wish for a parameter of a part",
                       .arguments = "PART PARAMETER SIGMAS",
                       .run = wish_command,
                       .why_not = needs_collection},
                      {.name = "save-plot-svg",
                       .title = "Save the plot as SVG…",
                       .menu = "File",
                       .arguments = "[FILE.svg]",
                       .run = save_plot<save_svg, svg>,
                       .why_not = needs_figure},
                      {.name = "save-plot-csv",
                       .title = "Save the plot's values as CSV…",
                       .menu = "File",
                       .arguments = "[FILE.csv]",
                       .run = save_plot<save_csv, csv>,
                       .why_not = needs_figure},
                      {.name = "evaluate-labels",
                       .title = "Compare with true labels…",
                       .menu = "Shape",
                       .arguments = "[FOLDER]",
                       .run = evaluate_labels_command,
                       .why_not = needs_fits_at_rest,
                       .separator = true},
                      {.name = "evaluate-landmarks",
                       .title = "Compare with landmarks…",
                       .menu = "Shape",
                       .arguments = "[FOLDER]",
                       .run = evaluate_landmarks_command,
                       .why_not = needs_fits_at_rest},
                      {.name = "measure-sizes",
                       .title = "Measure learning by collection size",
                       .menu = "Shape",
                       .run = [](Studio& s, Arguments) { measure_sizes(s); },
                       .why_not = needs_shapes_and_template},
                      {.name = "measure-starts",
                       .title = "Learn from several starts, to compare",
                       .menu = "Shape",
                       .run = [](Studio& s, Arguments) { measure_starts(s); },
                       .why_not = needs_any_shape},
                  });
}

}  // namespace archetype
