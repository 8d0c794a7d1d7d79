#include "ui/inspect_actions.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/session/current_templates.h"
#include "core/session/fit_collection.h"
#include "ui/inspection.h"
#include "ui/project_actions.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {

NamedShape shape_in_view(const Studio& studio) {
  const auto row = studio.ui.shape ? find_row(studio.collection, *studio.ui.shape) : std::nullopt;
  if (!row) throw Error("click a shape in the collection first");
  return {*studio.ui.shape, studio.collection.rows()[*row].name};
}

std::vector<NamedShape> shapes_to_correct(const Studio& studio) {
  const NamedShape in_view = shape_in_view(studio);
  if (!is_selected(studio.ui.selection, in_view.id)) return {in_view};
  std::vector<NamedShape> shapes;
  for (const ShapeRow& row : studio.collection.rows())
    if (is_selected(studio.ui.selection, row.id)) shapes.push_back({row.id, row.name});
  return shapes;
}

void pin_shown(Studio& studio) {
  const std::shared_ptr<const InspectedShape> shape = studio.inspection.main.shape;
  if (!shape) throw Error("wait until the shape is read");
  std::optional<ChosenAlternative> shown = shown_alternative(studio);
  if (!shown && shape->fit)
    shown = ChosenAlternative{shape->fit->part_template, shape->fit->fit.yaw_quarters};
  if (!shown) throw Error("the shape has no fit yet; fit the template to all shapes first");
  std::string name = shape->part_template ? shape->part_template->name : "";
  for (const TemplateRecord& each : shape->templates)
    if (each.id == shown->part_template) name = each.part_template.name;
  pin_yaw_and_template(studio.history, shape_in_view(studio), shown->yaw_quarters, name);
  studio.ui.inspect.chosen.reset();
  studio.ui.inspect.step.reset();
}

void refit_outdated(Studio& studio) {
  const auto path = studio.collection.path;
  const auto threads = static_cast<unsigned>(studio.settings.threads);
  const Document document = studio.history.committed();
  const JobId job = studio.jobs.start(
      "Fit what was corrected", [&studio, path, threads, document](const JobControl& control) -> Jobs::Apply {
        Project project = Project::open(path);
        store_corrections(project, document);
        const std::vector<PartTemplate> templates = current_templates(project).templates;
        if (templates.empty()) throw Error("the shapes were not fitted yet; fit the template to all shapes");
        const FitCollectionReport report = fit_collection(project, templates, {}, threads, control);
        return [&studio, report] {
          for (const RefusedInput& input : report.refused)
            studio.messages.warn(input.path.string() + ": " + input.reason);
          say(studio, Severity::note,
              plural(report.fitted, "shape") + " fitted anew" +
                  (report.cancelled ? "; stopped, do it again to go on" : ""));
        };
      });
  studio.writers.push_back({.job = job, .project = path, .fits = true});
}

void step_beside(Studio& studio, int step) {
  const NamedShape in_view = shape_in_view(studio);
  const auto& rows = studio.collection.rows();
  const std::size_t count = rows.size();
  const std::size_t own = *find_row(studio.collection, in_view.id);
  auto& beside = studio.ui.inspect.beside;
  const auto now = beside ? find_row(studio.collection, *beside) : std::nullopt;
  const auto same_cluster = [&](std::size_t i) {
    return !rows[own].fit || (rows[i].fit && rows[i].fit->part_template == rows[own].fit->part_template);
  };
  std::size_t at = now.value_or(own);
  for (std::size_t tried = 0; tried < count; ++tried) {
    at = (at + count + static_cast<std::size_t>(step + static_cast<int>(count))) % count;
    if (at == own || !same_cluster(at)) continue;
    if (!beside) studio.inspection.framed = false;  // there is half the room now
    beside = rows[at].id;
    return;
  }
  throw Error("no other shape is fitted by the same template");
}

}  // namespace archetype
