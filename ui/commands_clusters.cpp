// The view of the clusters, and what is measured of large collections.
#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "ui/cluster_card.h"
#include "ui/clusters_view.h"
#include "ui/command_groups.h"
#include "ui/learning_actions.h"
#include "ui/studio.h"
#include "ui/template_of_shape.h"

namespace archetype {
namespace {

void show_command(Studio& studio, Arguments) {
  studio.ui.centre = CentreView::clusters;
}

bool is_shown(const Studio& studio) {
  return studio.ui.centre == CentreView::clusters;
}

void expand_command(Studio& studio, Arguments) {
  const bool all = !studio.ui.clusters.expanded.empty();
  studio.ui.clusters.expanded.clear();
  if (all) return;
  for (const ShapeCluster& cluster : follow_clusters(studio))
    set_expanded(studio, cluster_key(studio, cluster), true);
}

// Of the cluster that the shape in view is in, where it is known; else the whole tree.
void tree_command(Studio& studio, Arguments) {
  const std::optional<std::size_t> row =
      studio.ui.shape ? find_row(studio.collection, *studio.ui.shape) : std::nullopt;
  const auto& rows = studio.collection.rows();
  if (!row || !rows[*row].fit) {
    show_learning(studio);
    return;
  }
  try {
    show_in_family_tree(studio, rows[*row].fit->part_template);
  } catch (const Error&) {
    show_learning(studio);
  }
}

std::string needs_learning(const Studio& studio) {
  return studio.collection.content.learning ? "" : "learn from the shapes first";
}

std::string needs_clusters(const Studio& studio) {
  if (std::string reason = needs_collection(studio); !reason.empty()) return reason;
  return studio.ui.centre == CentreView::clusters ? "" : "show the clusters first";
}

void highlight_command(Studio& studio, Arguments arguments) {
  std::optional<PartOfTemplate>& part = studio.ui.selection.part;
  part.reset();
  if (arguments.empty()) return;
  const std::string name = text_argument(arguments, 0, "the name of a part");
  const std::shared_ptr<const FitTable> table = use_fit_table(studio);
  if (!table) throw Error("the fits are still being read; say `wait` before");
  for (const TemplateRecord& record : table->templates) {
    const auto found = std::ranges::find(record.part_template.parts, name, &TemplatePart::name);
    if (found == record.part_template.parts.end()) continue;
    part = PartOfTemplate{record.id, static_cast<std::size_t>(found - record.part_template.parts.begin())};
    return;
  }
  throw Error("no template has a part \"" + name + "\"");
}

void select_shown(Studio& studio, Arguments) {
  select_only(studio.ui.selection, shown_shape_ids(studio));
}

// The shape that is named, or the one in view.
ShapeId shape_argument(const Studio& studio, Arguments arguments) {
  if (arguments.empty()) {
    if (!studio.ui.shape) throw Error("show a shape first, or name one");
    return *studio.ui.shape;
  }
  const std::string name = text_argument(arguments, 0, "the name of a shape");
  const auto row = std::ranges::find(studio.collection.rows(), name, &ShapeRow::name);
  if (row == studio.collection.rows().end()) throw Error("the collection has no shape \"" + name + "\"");
  return row->id;
}

void open_command(Studio& studio, Arguments arguments) {
  open_shape(studio, shape_argument(studio, arguments));
}

void template_command(Studio& studio, Arguments arguments) {
  make_template_of_shape(studio, shape_argument(studio, arguments));
}

template <CellStep step, bool extend>
void step_command(Studio& studio, Arguments) {
  step_in_clusters(studio, step, extend);
}

int frames_argument(Arguments arguments) {
  const double frames = number_argument(arguments, 0, "how many frames");
  if (frames < 1 || frames > 100'000) throw Error("expected between 1 and 100000 frames");
  return static_cast<int>(frames);
}

void scroll_clusters(Studio& studio, Arguments arguments) {
  studio.scroll = ScriptedScroll{.clusters = true, .frames = frames_argument(arguments)};
}

void scroll_grid(Studio& studio, Arguments arguments) {
  studio.scroll = ScriptedScroll{.clusters = false, .frames = frames_argument(arguments)};
}

void report_opening(Studio& studio, Arguments) {
  const std::optional<double>& took = studio.opening.milliseconds();
  if (!took) throw Error("no project was opened yet");
  const std::optional<std::size_t> memory = resident_memory();
  char line[160];
  std::snprintf(line, sizeof line, "opening: %zu shapes, %.0f ms to the first frame, resident memory %.0f MB",
                studio.collection.rows().size(), *took, static_cast<double>(memory.value_or(0)) / 1e6);
  studio.output.emplace_back(line);
}

}  // namespace

void add_clusters_commands(std::vector<Command>& commands) {
  commands.insert(commands.end(),
                  {
                      {.name = "show-clusters",
                       .title = "Clusters",
                       .menu = "View",
                       .key = "Alt+2",
                       .run = show_command,
                       .checked = is_shown},
                      {.name = "cluster-spread",
                       .title = "Spread of the parts in the clusters",
                       .menu = "View",
                       .run = [](Studio& s, Arguments) { s.ui.clusters.spread = !s.ui.clusters.spread; },
                       .checked = [](const Studio& s) { return s.ui.clusters.spread; }},
                      {.name = "expand-clusters",
                       .title = "All members of all clusters",
                       .menu = "View",
                       .run = expand_command,
                       .why_not = needs_collection,
                       .checked = [](const Studio& s) { return !s.ui.clusters.expanded.empty(); }},
                      {.name = "family-tree",
                       .title = "Family tree of the templates",
                       .menu = "View",
                       .run = tree_command,
                       .why_not = needs_learning},
                      {.name = "highlight-part",
                       .title = "Highlight a part on all shapes",
                       .arguments = "[PART]",
                       .run = highlight_command,
                       .why_not = needs_collection},
                      {.name = "open-shape",
                       .title = "Open the shape by itself",
                       .menu = "Shape",
                       .arguments = "[NAME]",
                       .run = open_command,
                       .why_not = needs_any_shape},
                      {.name = "template-from-shape",
                       .title = "Make a template from this shape",
                       .menu = "Shape",
                       .arguments = "[NAME]",
                       .run = template_command,
                       .why_not = needs_any_shape},
                      {.name = "select-shown",
                       .title = "Select all shapes that are shown",
                       .menu = "Shape",
                       .key = "Ctrl+Shift+A",
                       .run = select_shown,
                       .why_not = needs_collection},
                      {.name = "shape-above",
                       .title = "Shape above, in the clusters",
                       .menu = "Shape",
                       .key = "Up",
                       .run = step_command<CellStep::up, false>,
                       .why_not = needs_clusters},
                      {.name = "shape-below",
                       .title = "Shape below, in the clusters",
                       .menu = "Shape",
                       .key = "Down",
                       .run = step_command<CellStep::down, false>,
                       .why_not = needs_clusters},
                      {.name = "extend-right",
                       .title = "Select the next shape too",
                       .key = "Shift+Right",
                       .run = step_command<CellStep::right, true>,
                       .why_not = needs_clusters},
                      {.name = "extend-left",
                       .title = "Select the shape before too",
                       .key = "Shift+Left",
                       .run = step_command<CellStep::left, true>,
                       .why_not = needs_clusters},
                      {.name = "extend-down",
                       .title = "Select down to the shape below",
                       .key = "Shift+Down",
                       .run = step_command<CellStep::down, true>,
                       .why_not = needs_clusters},
                      {.name = "extend-up",
                       .title = "Select up to the shape above",
                       .key = "Shift+Up",
                       .run = step_command<CellStep::up, true>,
                       .why_not = needs_clusters},
                      {.name = "scroll-clusters",
                       .title = "Scroll through the clusters, to measure frames",
                       .arguments = "FRAMES",
                       .run = scroll_clusters,
                       .why_not = needs_clusters},
                      {.name = "scroll-grid",
                       .title = "Scroll through the collection, to measure frames",
                       .arguments = "FRAMES",
                       .run = scroll_grid,
                       .why_not = needs_collection},
                      {.name = "report-opening",
                       .title = "Print how long the project took to open",
                       .run = report_opening},
                  });
}

}  // namespace archetype
