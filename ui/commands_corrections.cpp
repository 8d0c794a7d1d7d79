// What is corrected of the shape in view, and of those that are selected with it.
#include <algorithm>

#include "core/base/error.h"
#include "ui/command_groups.h"
#include "ui/inspect_actions.h"
#include "ui/inspection.h"
#include "ui/studio.h"

namespace archetype {
namespace {

std::string needs_row(const Studio& studio) {
  if (std::string reason = needs_collection(studio); !reason.empty()) return reason;
  return studio.ui.shape ? "" : "click a shape in the collection first";
}

std::string needs_outdated(const Studio& studio) {
  if (std::string reason = needs_free_shapes(studio); !reason.empty()) return reason;
  if (!studio.inspection.main.shape) return "show the fit of a shape first (Alt+3)";
  return outdated_fits(studio) > 0 ? "" : "all fits are as they were corrected";
}

void pin_shown_command(Studio& studio, Arguments) {
  pin_shown(studio);
}

void pin_yaw_command(Studio& studio, Arguments arguments) {
  pin_yaw(studio.history, shape_in_view(studio), yaw_argument(arguments, 0));
}

void free_yaw(Studio& studio, Arguments) {
  pin_yaw(studio.history, shape_in_view(studio), std::nullopt);
}

void pin_template_command(Studio& studio, Arguments arguments) {
  pin_template(studio.history, shape_in_view(studio), text_argument(arguments, 0, "the name of a template"));
}

void free_template(Studio& studio, Arguments) {
  pin_template(studio.history, shape_in_view(studio), "");
}

void free_points(Studio& studio, Arguments) {
  unpin_all_samples(studio.history, shape_in_view(studio));
}

template <ShapeMark Mark>
bool has_mark(const Studio& studio) {
  return correction_in_view(studio).mark == Mark;
}

// The shape that is named; else the one in view and those that are selected with it.
std::vector<NamedShape> shapes_meant(const Studio& studio, Arguments arguments) {
  if (arguments.empty()) return shapes_to_correct(studio);
  const std::string name = text_argument(arguments, 0, "the name of a shape");
  const auto row = std::ranges::find(studio.collection.rows(), name, &ShapeRow::name);
  if (row == studio.collection.rows().end()) throw Error("the collection has no shape \"" + name + "\"");
  return {{row->id, name}};
}

// Without a name it is a switch.
template <ShapeMark Mark>
void mark(Studio& studio, Arguments arguments) {
  const bool off = arguments.empty() && has_mark<Mark>(studio);
  mark_shapes(studio.history, shapes_meant(studio, arguments), off ? ShapeMark::none : Mark);
}

void unmark(Studio& studio, Arguments arguments) {
  mark_shapes(studio.history, shapes_meant(studio, arguments), ShapeMark::none);
}

void clear_command(Studio& studio, Arguments) {
  clear_corrections(studio.history, shapes_to_correct(studio));
}

std::string needs_correction(const Studio& studio) {
  if (std::string reason = needs_row(studio); !reason.empty()) return reason;
  return correction_in_view(studio).empty() ? "nothing of this shape was corrected" : "";
}

std::string needs_pinned_yaw(const Studio& studio) {
  if (std::string reason = needs_row(studio); !reason.empty()) return reason;
  return correction_in_view(studio).yaw_quarters ? "" : "its yaw is not pinned";
}

std::string needs_pinned_template(const Studio& studio) {
  if (std::string reason = needs_row(studio); !reason.empty()) return reason;
  return correction_in_view(studio).part_template.empty() ? "its template is not pinned" : "";
}

std::string needs_pinned_points(const Studio& studio) {
  if (std::string reason = needs_row(studio); !reason.empty()) return reason;
  return correction_in_view(studio).pinned.empty() ? "none of its points is pinned" : "";
}

void refit_command(Studio& studio, Arguments) {
  refit_outdated(studio);
}

// With a name: the part that the brush paints.
void paint_command(Studio& studio, Arguments arguments) {
  InspectOptions& options = studio.ui.inspect;
  if (arguments.empty()) {
    options.painting = !options.painting;
    if (options.painting && options.paint_part.empty() && !options.freeing && studio.inspection.main.look)
      options.paint_part = studio.inspection.main.look->part_template->parts.front().name;
    return;
  }
  options.painting = true;
  options.freeing = false;
  options.paint_part = text_argument(arguments, 0, "the name of a part");
}

bool paints(const Studio& studio) {
  return studio.ui.inspect.painting;
}

}  // namespace

void add_correction_commands(std::vector<Command>& commands) {
  commands.insert(commands.end(), {
                                      {.name = "pin-shown",
                                       .title = "Pin the yaw and template that are shown",
                                       .menu = "Shape",
                                       .run = pin_shown_command,
                                       .why_not = needs_inspected,
                                       .separator = true,
                                       .edits = true},
                                      {.name = "pin-yaw",
                                       .title = "Pin the yaw of the shape",
                                       .arguments = "DEGREES",
                                       .run = pin_yaw_command,
                                       .why_not = needs_row,
                                       .edits = true},
                                      {.name = "free-yaw",
                                       .title = "Free the yaw of the shape",
                                       .run = free_yaw,
                                       .why_not = needs_pinned_yaw,
                                       .edits = true},
                                      {.name = "pin-template",
                                       .title = "Pin the template of the shape",
                                       .arguments = "NAME",
                                       .run = pin_template_command,
                                       .why_not = needs_row,
                                       .edits = true},
                                      {.name = "free-template",
                                       .title = "Free the template of the shape",
                                       .run = free_template,
                                       .why_not = needs_pinned_template,
                                       .edits = true},
                                      {.name = "paint-labels",
                                       .title = "Paint parts onto the shape",
                                       .menu = "Shape",
                                       .arguments = "[PART]",
                                       .run = paint_command,
                                       .why_not = needs_inspected,
                                       .checked = paints},
                                      {.name = "free-points",
                                       .title = "Free the painted points",
                                       .menu = "Shape",
                                       .run = free_points,
                                       .why_not = needs_pinned_points,
                                       .edits = true},
                                      {.name = "mark-outlier",
                                       .title = "Mark as outlier",
                                       .menu = "Shape",
                                       .arguments = "[NAME]",
                                       .run = mark<ShapeMark::outlier>,
                                       .why_not = needs_any_shape,
                                       .checked = has_mark<ShapeMark::outlier>,
                                       .edits = true},
                                      {.name = "learn-from-shape",
                                       .title = "Learn from this shape",
                                       .menu = "Shape",
                                       .arguments = "[NAME]",
                                       .run = mark<ShapeMark::learn>,
                                       .why_not = needs_any_shape,
                                       .checked = has_mark<ShapeMark::learn>,
                                       .edits = true},
                                      {.name = "unmark-outlier",
                                       .title = "Take the mark away",
                                       .menu = "Shape",
                                       .arguments = "[NAME]",
                                       .run = unmark,
                                       .why_not = needs_any_shape,
                                       .edits = true},
                                      {.name = "clear-corrections",
                                       .title = "Clear the corrections of the shape",
                                       .menu = "Shape",
                                       .run = clear_command,
                                       .why_not = needs_correction,
                                       .edits = true},
                                      {.name = "refit-corrected",
                                       .title = "Fit what was corrected",
                                       .menu = "Shape",
                                       .key = "Ctrl+Shift+Enter",
                                       .run = refit_command,
                                       .why_not = needs_outdated},
                                  });
}

}  // namespace archetype
