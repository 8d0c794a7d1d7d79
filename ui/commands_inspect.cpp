// The view of a single fit.
#include <algorithm>
#include <array>

#include "core/base/error.h"
#include "ui/command_groups.h"
#include "ui/inspect_actions.h"
#include "ui/inspection.h"
#include "ui/kept_choices.h"
#include "ui/studio.h"
#include "ui/switch_setting.h"

namespace archetype {
namespace {

void show_inspect(Studio& studio, Arguments) {
  studio.ui.centre = CentreView::inspect;
}

bool inspect_is_shown(const Studio& studio) {
  return studio.ui.centre == CentreView::inspect;
}

void colour_by(Studio& studio, Arguments arguments) {
  const std::string name = text_argument(arguments, 0, "part, plain, distance, features or smoothness");
  if (!find_inspect_colour(name)) throw Error("expected part, plain, distance, features or smoothness");
  studio.settings.inspect_colour = name;
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

std::string needs_another(const Studio& studio) {
  if (std::string reason = needs_inspected(studio); !reason.empty()) return reason;
  return studio.collection.rows().size() > 1 ? "" : "there is no other shape";
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
  if (arguments.empty()) return pick_inspected_part(studio, std::nullopt);
  const std::string name = text_argument(arguments, 0, "the name of a part");
  const auto& look = studio.inspection.main.look;
  if (!look) throw Error("wait for the fit");
  const auto& parts = look->part_template->parts;
  const auto found = std::ranges::find(parts, name, &TemplatePart::name);
  if (found == parts.end()) throw Error("the template has no part " + name);
  pick_inspected_part(studio, static_cast<std::size_t>(found - parts.begin()));
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
                                       .run = toggle_setting<&Settings::inspect_fitted_boxes>,
                                       .checked = setting_is_on<&Settings::inspect_fitted_boxes>},
                                      {.name = "inspect-mean-boxes",
                                       .title = "Mean boxes of the inspected fit",
                                       .run = toggle_setting<&Settings::inspect_mean_boxes>,
                                       .checked = setting_is_on<&Settings::inspect_mean_boxes>},
                                      {.name = "inspect-template-points",
                                       .title = "Points of the template, by their distance to the shape",
                                       .run = toggle_setting<&Settings::inspect_template_points>,
                                       .checked = setting_is_on<&Settings::inspect_template_points>},
                                      {.name = "inspect-correspondences",
                                       .title = "Correspondences of the inspected fit",
                                       .run = toggle_setting<&Settings::inspect_correspondences>,
                                       .checked = setting_is_on<&Settings::inspect_correspondences>},
                                      {.name = "inspect-samples",
                                       .title = "Samples of the inspected shape",
                                       .run = toggle_setting<&Settings::inspect_samples>,
                                       .checked = setting_is_on<&Settings::inspect_samples>},
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
                                       .why_not = needs_another},
                                      {.name = "previous-beside",
                                       .title = "Show the shape before beside",
                                       .run = previous_beside,
                                       .why_not = needs_another},
                                      {.name = "inspect-alone",
                                       .title = "Show only the shape in view",
                                       .run = show_alone,
                                       .why_not = needs_beside},
                                  });
}

}  // namespace archetype
