// The menu Template: whole templates.
#include <algorithm>
#include <utility>

#include "core/base/error.h"
#include "core/io/template_file.h"
#include "core/session/actions.h"
#include "ui/command_groups.h"
#include "ui/file_browser.h"
#include "ui/project_actions.h"
#include "ui/selection.h"
#include "ui/studio.h"
#include "ui/template_compare.h"

namespace archetype {
namespace {

void new_template(Studio& studio, Arguments arguments) {
  PartTemplate part_template;
  part_template.name = arguments.empty() ? "template" : text_argument(arguments, 0, "a name");
  add_template(studio.history, std::move(part_template), "New template");
  select_only(studio.ui, std::nullopt);
}

void start_from(Studio& studio, Arguments arguments) {
  const std::string name = text_argument(arguments, 0, "the name of a starting template");
  const std::filesystem::path path = starting_template_path(studio, name);
  if (!path.empty()) {
    load_template(studio, path);
    return;
  }
  std::string known;
  for (const std::string& each : starting_templates(studio)) known += (known.empty() ? "" : ", ") + each;
  throw Error("there is no starting template \"" + name + "\"; there are " + known);
}

void load_command(Studio& studio, Arguments arguments) {
  if (arguments.empty())
    browse(studio, {.command = "load-template", .title = "Load a template", .ending = ".json"});
  else
    load_template(studio, text_argument(arguments, 0, "a template file"));
}

void save_command(Studio& studio, Arguments arguments) {
  if (!arguments.empty()) return save_template(studio, text_argument(arguments, 0, "a path"));
  std::string name = studio.history.committed().active_template()->name;
  std::replace(name.begin(), name.end(), '/', '_');
  browse(studio, {.command = "save-template",
                  .title = "Save the template as",
                  .saving = true,
                  .ending = ".json",
                  .proposed = std::move(name)});
}

void rename_command(Studio& studio, Arguments arguments) {
  rename_active_template(studio.history, text_argument(arguments, 0, "a name"));
}

void duplicate_command(Studio& studio, Arguments) {
  duplicate_active_template(studio.history);
}

void delete_command(Studio& studio, Arguments) {
  remove_active_template(studio.history);
  select_only(studio.ui, std::nullopt);
}

void select_command(Studio& studio, Arguments arguments) {
  const std::string name = text_argument(arguments, 0, "the name of a template");
  const auto& templates = studio.history.committed().templates;
  for (std::size_t i = 0; i < templates.size(); ++i) {
    if (templates[i]->name != name) continue;
    select_template(studio.history, i);
    select_only(studio.ui, std::nullopt);
    return;
  }
  throw Error("there is no template \"" + name + "\"");
}

template <int places>
void move_command(Studio& studio, Arguments) {
  move_active_template(studio.history, places);
}

template <int places>
std::string needs_place(const Studio& studio) {
  if (std::string reason = needs_template(studio); !reason.empty()) return reason;
  const Document& document = studio.history.committed();
  if (places < 0) return document.active > 0 ? "" : "it is the first template already";
  return document.active + 1 < document.templates.size() ? "" : "it is the last template already";
}

void compare_command(Studio& studio, Arguments arguments) {
  const Document& document = studio.history.committed();
  // Without a name: with the next one of the list.
  const std::size_t next = (document.active + 1) % document.templates.size();
  const std::string name = arguments.empty() ? document.templates[next]->name
                                             : text_argument(arguments, 0, "the name of a template");
  for (const auto& each : document.templates)
    if (each->name == name && each != document.templates[document.active]) {
      studio.ui.compared = name;
      return;
    }
  throw Error("there is no other template \"" + name + "\"");
}

void stop_comparing_command(Studio& studio, Arguments) {
  studio.ui.compared.clear();
}

std::string needs_other_template(const Studio& studio) {
  if (std::string reason = needs_template(studio); !reason.empty()) return reason;
  return studio.history.committed().templates.size() > 1 ? "" : "there is no other template";
}

std::string needs_compared(const Studio& studio) {
  return compared_template(studio) ? "" : "no template is compared";
}

void adopt_command(Studio& studio, Arguments) {
  adopt_fitted_boxes(studio.history, studio.shape.fit->fit);
}

void learn_command(Studio& studio, Arguments) {
  learn_features(studio.history, *studio.shape.samples, studio.shape.fit->fit);
}

void forget_command(Studio& studio, Arguments) {
  forget_features(studio.history);
}

}  // namespace

void add_template_commands(std::vector<Command>& commands) {
  commands.insert(commands.end(), {
                                      {.name = "new-template",
                                       .title = "New template",
                                       .menu = "Template",
                                       .key = "Ctrl+N",
                                       .arguments = "[NAME]",
                                       .run = new_template,
                                       .edits = true},
                                      {.name = "start-template",
                                       .title = "Start from a template that comes with the program",
                                       .arguments = "NAME",
                                       .run = start_from,
                                       .edits = true},
                                      {.name = "load-template",
                                       .title = "Load template…",
                                       .menu = "Template",
                                       .arguments = "[FILE.json]",
                                       .run = load_command,
                                       .edits = true},
                                      {.name = "save-template",
                                       .title = "Save template as…",
                                       .menu = "Template",
                                       .arguments = "[FILE.json]",
                                       .run = save_command,
                                       .why_not = needs_template},
                                      {.name = "select-template",
                                       .title = "Switch to a template",
                                       .arguments = "NAME",
                                       .run = select_command,
                                       .why_not = needs_template,
                                       .edits = true},
                                      {.name = "rename-template",
                                       .title = "Rename the template",
                                       .arguments = "NAME",
                                       .run = rename_command,
                                       .why_not = needs_template,
                                       .edits = true},
                                      {.name = "duplicate-template",
                                       .title = "Duplicate template",
                                       .menu = "Template",
                                       .run = duplicate_command,
                                       .why_not = needs_template,
                                       .separator = true,
                                       .edits = true},
                                      {.name = "template-up",
                                       .title = "Move the template up in the list",
                                       .menu = "Template",
                                       .run = move_command<-1>,
                                       .why_not = needs_place<-1>,
                                       .edits = true},
                                      {.name = "template-down",
                                       .title = "Move the template down in the list",
                                       .menu = "Template",
                                       .run = move_command<1>,
                                       .why_not = needs_place<1>,
                                       .edits = true},
                                      {.name = "compare-template",
                                       .title = "Compare with another template",
                                       .menu = "Template",
                                       .arguments = "[NAME]",
                                       .run = compare_command,
                                       .why_not = needs_other_template},
                                      {.name = "stop-comparing",
                                       .title = "Stop comparing templates",
                                       .menu = "Template",
                                       .run = stop_comparing_command,
                                       .why_not = needs_compared},
                                      {.name = "delete-template",
                                       .title = "Delete template",
                                       .menu = "Template",
                                       .run = delete_command,
                                       .why_not = needs_template,
                                       .edits = true},
                                      {.name = "adopt-fit",
                                       .title = "Take the boxes of the fit",
                                       .menu = "Template",
                                       .run = adopt_command,
                                       .why_not = needs_fit,
                                       .separator = true,
                                       .edits = true},
                                      {.name = "learn-features",
                                       .title = "Learn features from the shape",
                                       .menu = "Template",
                                       .run = learn_command,
                                       .why_not = needs_fit,
                                       .edits = true},
                                      {.name = "forget-features",
                                       .title = "Forget features",
                                       .menu = "Template",
                                       .run = forget_command,
                                       .why_not = needs_template,
                                       .edits = true},
                                  });
}

}  // namespace archetype
