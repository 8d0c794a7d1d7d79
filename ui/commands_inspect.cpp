// The view of a single fit, and corrections of the shape in view.
#include <algorithm>
#include <array>

#include "core/base/error.h"
#include "ui/command_groups.h"
#include "ui/inspect_actions.h"
#include "ui/inspection.h"
#include "ui/studio.h"

namespace archetype {
namespace {

void show_inspect(Studio& studio, Arguments) {
  studio.ui.centre = CentreView::inspect;
}

bool inspect_is_shown(const Studio& studio) {
  return studio.ui.centre == CentreView::inspect;
}

std::string needs_inspected(const Studio& studio) {
  if (std::string reason = needs_shape(studio); !reason.empty()) return reason;
  if (!inspect_is_shown(studio)) return "show the fit first (Alt+3)";
  return studio.inspection.main.shape ? "" : "wait until the shape is read";
}

std::string needs_row(const Studio& studio) {
  if (std::string reason = needs_collection(studio); !reason.empty()) return reason;
  return studio.ui.shape ? "" : "click a shape in the collection first";
}

std::string needs_outdated(const Studio& studio) {
  if (std::string reason = needs_free_shapes(studio); !reason.empty()) return reason;
  if (!studio.inspection.main.shape) return "show the fit of a shape first (Alt+3)";
  return outdated_fits(studio) > 0 ? "" : "all fits are as they were corrected";
}

template <bool InspectOptions::*Option>
void toggle(Studio& studio, Arguments) {
  studio.ui.inspect.*Option = !(studio.ui.inspect.*Option);
}

template <bool InspectOptions::*Option>
bool is_on(const Studio& studio) {
  return studio.ui.inspect.*Option;
}

void colour_by(Studio& studio, Arguments arguments) {
  constexpr std::array<std::pair<std::string_view, InspectColour>, 5> names{
      {{"part", InspectColour::part},
       {"plain", InspectColour::plain},
       {"distance", InspectColour::shape_to_template},
       {"features", InspectColour::features},
       {"smoothness", InspectColour::smoothness}}};
  const std::string name = text_argument(arguments, 0, "part, plain, distance, features or smoothness");
  const auto found = std::ranges::find(names, name, &std::pair<std::string_view, InspectColour>::first);
  if (found == names.end()) throw Error("expected part, plain, distance, features or smoothness");
  studio.ui.inspect.colour = found->second;
}

int yaw_argument(Arguments arguments, std::size_t index) {
  const double degrees = number_argument(arguments, index, "0, 90, 180 or 270");
  for (int quarters = 0; quarters < 4; ++quarters)
    if (degrees == quarters * 90) return quarters;
  throw Error("expected 0, 90, 180 or 270");
}

void show_alternative(Studio& studio, Arguments arguments) {
  const int yaw = yaw_argument(arguments, 0);
  const std::string name = text_argument(arguments, 1, "a yaw and the name of a template");
  for (const TemplateRecord& each : studio.inspection.main.shape->templates) {
    if (each.part_template.name != name) continue;
    studio.ui.inspect.chosen = ChosenAlternative{each.id, yaw};
    studio.ui.inspect.step.reset();
    return;
  }
  throw Error("the project has no template " + name);
}

void show_stored(Studio& studio, Arguments) {
  studio.ui.inspect.chosen.reset();
  studio.ui.inspect.step.reset();
}

std::string needs_other_fit(const Studio& studio) {
  if (std::string reason = needs_inspected(studio); !reason.empty()) return reason;
  const bool other = studio.ui.inspect.chosen || studio.ui.inspect.step;
  return other ? "" : "it is what is shown";
}

void show_step(Studio& studio, Arguments arguments) {
  studio.ui.inspect.step.reset();
  if (arguments.empty()) return;
  const double step = number_argument(arguments, 0, "a number of alternations");
  if (step < 0 || step > 10'000) throw Error("expected a number of alternations");
  studio.ui.inspect.step = static_cast<std::size_t>(step);
}

void inspect_part(Studio& studio, Arguments arguments) {
  studio.ui.inspect.part.reset();
  if (arguments.empty()) return;
  const std::string name = text_argument(arguments, 0, "the name of a part");
  const auto& look = studio.inspection.main.look;
  if (!look) throw Error("wait for the fit");
  const auto& parts = look->part_template->parts;
  const auto found = std::ranges::find(parts, name, &TemplatePart::name);
  if (found == parts.end()) throw Error("the template has no part " + name);
  studio.ui.inspect.part = static_cast<std::size_t>(found - parts.begin());
}

void show_beside(Studio& studio, Arguments arguments) {
  if (arguments.empty()) {
    step_beside(studio, 1);
    return;
  }
  const std::string name = text_argument(arguments, 0, "the name of a shape");
  for (const ShapeRow& row : studio.collection.rows()) {
    if (row.name != name) continue;
    if (row.id == studio.ui.shape) throw Error("it is the shape in view");
    if (!studio.ui.inspect.beside) studio.inspection.framed = false;  // there is half the room now
    studio.ui.inspect.beside = row.id;
    return;
  }
  throw Error("the collection has no shape " + name);
}

void previous_beside(Studio& studio, Arguments) {
  step_beside(studio, -1);
}

void show_alone(Studio& studio, Arguments) {
  studio.ui.inspect.beside.reset();
  studio.inspection.framed = false;
}

std::string needs_beside(const Studio& studio) {
  return studio.ui.inspect.beside ? "" : "no shape is shown beside";
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

}  // namespace

void add_inspect_commands(std::vector<Command>& commands) {
  commands.insert(commands.end(), {
                                      {.name = "show-inspect",
                                       .title = "Inspect the fit",
                                       .menu = "View",
                                       .key = "Alt+3",
                                       .run = show_inspect,
                                       .checked = inspect_is_shown},
                                      {.name = "inspect-colour",
                                       .title = "Colour the inspected fit by",
                                       .arguments = "part|plain|distance|features|smoothness",
                                       .run = colour_by},
                                      {.name = "inspect-fitted-boxes",
                                       .title = "Fitted boxes of the inspected fit",
                                       .run = toggle<&InspectOptions::fitted_boxes>,
                                       .checked = is_on<&InspectOptions::fitted_boxes>},
                                      {.name = "inspect-mean-boxes",
                                       .title = "Mean boxes of the inspected fit",
                                       .run = toggle<&InspectOptions::mean_boxes>,
                                       .checked = is_on<&InspectOptions::mean_boxes>},
                                      {.name = "inspect-template-points",
                                       .title = "Points of the template, by their distance to the shape",
                                       .run = toggle<&InspectOptions::template_points>,
                                       .checked = is_on<&InspectOptions::template_points>},
                                      {.name = "inspect-correspondences",
                                       .title = "Correspondences of the inspected fit",
                                       .run = toggle<&InspectOptions::correspondences>,
                                       .checked = is_on<&InspectOptions::correspondences>},
                                      {.name = "inspect-samples",
                                       .title = "Samples of the inspected shape",
                                       .run = toggle<&InspectOptions::samples>,
                                       .checked = is_on<&InspectOptions::samples>},
                                      {.name = "inspect-alternative",
                                       .title = "Show the fit of another yaw and template",
                                       .arguments = "DEGREES TEMPLATE",
                                       .run = show_alternative,
                                       .why_not = needs_inspected},
                                      {.name = "inspect-stored",
                                       .title = "Show the fit of the project",
                                       .run = show_stored,
                                       .why_not = needs_other_fit},
                                      {.name = "inspect-step",
                                       .title = "Show the fit after so many alternations",
                                       .arguments = "[NUMBER]",
                                       .run = show_step,
                                       .why_not = needs_inspected},
                                      {.name = "inspect-part",
                                       .title = "Inspect one part",
                                       .arguments = "[NAME]",
                                       .run = inspect_part,
                                       .why_not = needs_inspected},
                                      {.name = "inspect-beside",
                                       .title = "Show another shape of the cluster beside",
                                       .menu = "View",
                                       .arguments = "[NAME]",
                                       .run = show_beside,
                                       .why_not = needs_inspected},
                                      {.name = "previous-beside",
                                       .title = "Show the shape before beside",
                                       .run = previous_beside,
                                       .why_not = needs_inspected},
                                      {.name = "inspect-alone",
                                       .title = "Show only the shape in view",
                                       .run = show_alone,
                                       .why_not = needs_beside},
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
                                       .checked = is_on<&InspectOptions::painting>},
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
                                       .why_not = needs_collection,
                                       .checked = has_mark<ShapeMark::outlier>,
                                       .edits = true},
                                      {.name = "learn-from-shape",
                                       .title = "Learn from this shape",
                                       .menu = "Shape",
                                       .arguments = "[NAME]",
                                       .run = mark<ShapeMark::learn>,
                                       .why_not = needs_collection,
                                       .checked = has_mark<ShapeMark::learn>,
                                       .edits = true},
                                      {.name = "unmark-outlier",
                                       .title = "Take the mark away",
                                       .menu = "Shape",
                                       .arguments = "[NAME]",
                                       .run = unmark,
                                       .why_not = needs_collection,
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
