// Jobs that end in an edit of the document.
#include "ui/learning_actions.h"

#include "core/session/actions.h"
#include "core/session/learn_templates.h"
#include "core/session/suggest_templates.h"
#include "ui/project_actions.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

std::vector<PartTemplate> current_templates(const Project& project) {
  std::vector<PartTemplate> templates;
  for (TemplateRecord& record : project.templates()) templates.push_back(std::move(record.part_template));
  return templates;
}

std::vector<PartTemplate> templates_of(const Document& document) {
  std::vector<PartTemplate> templates;
  for (const auto& each : document.templates) templates.push_back(*each);
  return templates;
}

std::string summary(const LearnReport& report, std::size_t templates) {
  std::string text = "Learned " + plural(templates, "template") + " in " +
                     plural(report.steps.size(), "round") + "; " + plural(report.learned, "shape") +
                     " fit well, " + plural(report.outliers, "outlier");
  if (report.cancelled)
    text = "Learning stopped after " + plural(report.steps.size(), "round") + "; learn again to go on";
  return text;
}

}  // namespace

void suggest_templates(Studio& studio) {
  const auto path = studio.collection.path;
  const auto threads = static_cast<unsigned>(studio.settings.threads);
  studio.jobs.start("Suggest templates", [&studio, path, threads](const JobControl& control) -> Jobs::Apply {
    const Project project = Project::open(path);
    Suggestions found = suggest_templates(project, SuggestOptions{}, threads, control);
    return [&studio, path, found = std::move(found)] {
      if (found.cancelled || studio.collection.path != path) return;
      studio.ui.suggestions = found.templates;
      studio.ui.show_suggestions = true;
      say(studio, Severity::note, plural(found.templates.size(), "template") + " suggested");
    };
  });
}

void take_suggestion(Studio& studio, std::size_t rank) {
  const PartTemplate& chosen = studio.ui.suggestions.at(rank).part_template;
  add_template(studio.history, chosen, "Take the suggested template " + chosen.name);
  studio.ui.part.reset();
}

void learn(Studio& studio) {
  const auto path = studio.collection.path;
  const auto threads = static_cast<unsigned>(studio.settings.threads);
  const Document document = studio.history.committed();
  const std::string title = "Learn from " + document.active_template()->name;
  const JobId job =
      studio.jobs.start(title, [&studio, path, threads, document](const JobControl& control) -> Jobs::Apply {
        Project project = Project::open(path);
        // The templates of the project may be those of a learning that was stopped: it is gone on with.
        const bool of_project = current_templates(project) == templates_of(document);
        const std::vector<PartTemplate> start =
            of_project ? learning_start(project) : std::vector{*document.active_template()};
        const LearnReport report = learn_templates(project, start, {}, {}, 1, false, threads, control);
        const std::vector<PartTemplate> learned = current_templates(project);
        return [&studio, path, document, of_project, report, learned] {
          if (studio.collection.path != path) return;
          // A template that was edited meanwhile stays; what was learned comes beside it.
          const bool same = studio.history.committed() == document;
          if (same) {
            take_learned(studio.history, learned, of_project ? LearnedFrom::all : LearnedFrom::active,
                         "Learn from " + document.active_template()->name);
          } else {
            for (const PartTemplate& each : learned) add_template(studio.history, each, "Learn " + each.name);
          }
          studio.ui.part.reset();
          say(studio, Severity::note, summary(report, learned.size()));
        };
      });
  studio.writers.push_back({job, path, true});
}

}  // namespace archetype
