// Jobs that end in an edit of the document.
#include "ui/learning_actions.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/fitting/fit_template.h"
#include "core/session/actions.h"
#include "core/session/automatic_start.h"
#include "core/session/current_templates.h"
#include "core/session/learn_templates.h"
#include "core/session/suggest_templates.h"
#include "ui/learning_flow.h"
#include "ui/project_actions.h"
#include "ui/selection.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

constexpr std::uint64_t learning_seed = 1;  // that of the batch program

std::vector<PartTemplate> templates_of(const Document& document) {
  std::vector<PartTemplate> templates;
  for (const auto& each : document.templates) templates.push_back(*each);
  return templates;
}

// The shape that a suggested template is named after, with its fit. Null if there is none, or cancelled.
std::shared_ptr<const SuggestionSource> source_of(const Project& project, const PartTemplate& suggested,
                                                  const JobControl& control) {
  constexpr std::string_view before_name = "from ";
  const std::size_t at = suggested.name.find(before_name);
  if (at == std::string::npos) return nullptr;
  const auto shape = project.find_shape(suggested.name.substr(at + before_name.size()));
  if (!shape) return nullptr;
  ShapeSamples samples = project.samples(shape->id);
  std::optional<ShapeFit> fit = fit_template(suggested, samples, {}, {control.stop, {}});
  if (!fit) return nullptr;
  return std::make_shared<const SuggestionSource>(SuggestionSource{std::move(samples), std::move(*fit)});
}

// The job that learns from the collection in view; null if none does.
const ProjectWriter* learner_of(const Studio& studio) {
  for (const ProjectWriter& writer : studio.writers)
    if (writer.learns && writer.project == studio.collection.path) return &writer;
  return nullptr;
}

// The templates of the document are those of the newest round, and all fits are theirs: learn() goes on, or
// begins where that learning began.
bool holds_learned(const Studio& studio) {
  const std::shared_ptr<const LearningRecord> record = studio.collection.content.learning;
  if (!record || record->steps.empty()) return false;
  const std::vector<TemplateId>& ids = record->steps.back().templates;
  const auto& templates = studio.history.committed().templates;
  if (ids.size() != templates.size()) return false;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const auto learned = std::ranges::find(record->templates, ids[i], &TemplateRecord::id);
    if (learned == record->templates.end() || learned->part_template != *templates[i]) return false;
  }
  return std::ranges::all_of(studio.collection.rows(), [&](const ShapeRow& row) {
    return !row.fit || std::ranges::find(ids, row.fit->part_template) != ids.end();
  });
}

// Learning begins with all templates of the document where these are the project's current ones, or those
// that its learning began with: that is undone, and shall be done again. Otherwise with the active one.
bool begins_with_all(const std::vector<PartTemplate>& of_document, const std::vector<PartTemplate>& current,
                     const LearningRecord* record) {
  return of_document == current || (record && of_document == record->start);
}

std::string names_of(const std::vector<PartTemplate>& templates) {
  constexpr std::size_t most = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, templates.size()); ++i)
    text += (i == 0 ? "“" : ", “") + templates[i].name + "”";
  return templates.size() > most ? text + " and " + std::to_string(templates.size() - most) + " more" : text;
}

std::string summary(const LearnReport& report, std::size_t templates) {
  std::string text = "Learned " + plural(templates, "template") + " in " +
                     plural(report.steps.size(), "round") + "; " + plural(report.learned, "shape") +
                     " fit well, " + plural(report.outliers, "outlier");
  if (report.cancelled)
    text = "Learning stopped after " + plural(report.steps.size(), "round") + "; learn again to go on";
  return text;
}

enum class Start { document, shapes };  // the templates of the document, or the best that the shapes suggest

void learn_from(Studio& studio, Start from) {
  const auto path = studio.collection.path;
  const auto threads = static_cast<unsigned>(studio.settings.threads);
  const Document document = studio.history.committed();
  const bool again = from == Start::document && holds_learned(studio);
  const std::string title = from == Start::shapes ? std::string("Learn from the shapes alone")
                            : again ? "Learn from " + studio.collection.content.learning->start.front().name
                                    : "Learn from " + document.active_template()->name;
  if (from == Start::document) say(studio, Severity::note, "Learning: " + what_learning_begins_with(studio));
  const JobId job = studio.jobs.start(
      title, [&studio, path, threads, document, from, title](const JobControl& control) -> Jobs::Apply {
        Project project = Project::open(path);
        store_corrections(project, document);
        const std::vector<PartTemplate> current = current_templates(project).templates;
        const auto record = learning_record(project);
        const bool all = from == Start::document &&
                         begins_with_all(templates_of(document), current, record ? &*record : nullptr);
        std::vector<PartTemplate> start;
        if (from == Start::shapes) {
          const auto chosen = automatic_start(project, {}, {}, learning_seed, threads, control);
          if (!chosen) return {};
          start = {*chosen};
        } else {
          start = all ? templates_of(document) : std::vector{*document.active_template()};
          // Those of a learning that was stopped: it is gone on with.
          if (start == current) start = learning_start(project);
        }
        const LearnReport report =
            learn_templates(project, start, {}, {}, learning_seed, false, threads, control);
        const std::vector<PartTemplate> learned = current_templates(project).templates;
        return [&studio, path, document, from, all, report, learned, title] {
          if (studio.collection.path != path) return;
          const bool nothing = report.cancelled && report.steps.empty();
          if (nothing)
            return say(studio, Severity::note,
                       "Learning stopped before the end of a round; nothing was changed");
          // A template that was edited meanwhile stays; what was learned comes beside it.
          const bool same = studio.history.committed() == document;
          const bool beside = from == Start::shapes && !document.templates.empty();
          if (same && !beside) {
            take_learned(studio.history, learned,
                         all || from == Start::shapes ? LearnedFrom::all : LearnedFrom::active, title);
          } else {
            for (const PartTemplate& each : learned) add_template(studio.history, each, "Learn " + each.name);
          }
          select_only(studio.ui, std::nullopt);
          say(studio, Severity::note, summary(report, learned.size()));
        };
      });
  studio.writers.push_back(
      {.job = job, .project = path, .fits = true, .learns = true, .rounds_before = rounds_learned(studio)});
  studio.ui.learning = {};
  show_learning(studio);
}

}  // namespace

void suggest_templates(Studio& studio) {
  const auto path = studio.collection.path;
  const auto threads = static_cast<unsigned>(studio.settings.threads);
  studio.jobs.start("Suggest templates", [&studio, path, threads](const JobControl& control) -> Jobs::Apply {
    const Project project = Project::open(path);
    Suggestions found = suggest_templates(project, SuggestOptions{}, threads, control);
    std::vector<Suggestion> suggestions;
    for (InitialTemplate& each : found.templates) {
      auto source = source_of(project, each.part_template, control);
      suggestions.push_back({std::move(each), std::move(source)});
    }
    if (control.cancelled()) return {};
    return [&studio, path, suggestions = std::move(suggestions)] {
      if (studio.collection.path != path) return;
      studio.ui.suggestions = suggestions;
      studio.ui.chosen_suggestion = 0;
      studio.ui.show_suggestions = true;
      say(studio, Severity::note, plural(suggestions.size(), "template") + " suggested");
    };
  });
}

void take_suggestion(Studio& studio, std::size_t rank) {
  const PartTemplate& chosen = studio.ui.suggestions.at(rank).found.part_template;
  add_template(studio.history, chosen, "Take the suggested template " + chosen.name);
  select_only(studio.ui, std::nullopt);
}

std::optional<JobView> learning_job(const Studio& studio) {
  const ProjectWriter* writer = learner_of(studio);
  if (!writer) return std::nullopt;
  for (const JobView& job : studio.jobs.view())
    if (job.id == writer->job) return job;
  return std::nullopt;
}

std::size_t rounds_learned(const Studio& studio) {
  const std::shared_ptr<const LearningRecord> record = studio.collection.content.learning;
  return record ? record->steps.size() : 0;
}

std::optional<double> most_seconds_of_rounds(const Studio& studio) {
  const std::optional<JobView> job = learning_job(studio);
  const std::shared_ptr<const LearningRecord> record = studio.collection.content.learning;
  if (!job || !record || record->settled) return std::nullopt;
  const std::size_t rounds = rounds_learned(studio);
  const std::size_t before = learner_of(studio)->rounds_before;
  const auto most = static_cast<std::size_t>(LearnOptions{}.iterations);
  if (rounds <= before || most < rounds) return std::nullopt;
  return estimate_seconds_left(job->seconds, rounds - before, most - before);
}

void look_into_round(Studio& studio, std::size_t round, std::size_t part_template) {
  const std::shared_ptr<const LearningRecord> record = studio.collection.content.learning;
  if (!record) throw Error("nothing was learned yet");
  const std::vector<FlowColumn> columns = learning_flow(*record);
  if (round >= columns.size() || part_template >= columns[round].nodes.size())
    throw Error("there is no such template");
  studio.ui.learning = {round, part_template};
  look_at(studio, *columns[round].nodes[part_template].part_template, round_name(round));
}

void show_learning(Studio& studio) {
  studio.settings.show_bottom = true;
  studio.ui.wanted_bottom_tab = BottomTab::learning;
}

std::string what_learning_begins_with(const Studio& studio) {
  const Document& document = studio.history.committed();
  const std::size_t count = document.templates.size();
  if (!holds_learned(studio)) {
    const CollectionRows& content = studio.collection.content;
    if (count > 1 && begins_with_all(templates_of(document), content.templates, content.learning.get()))
      return "begins with " + names_of(templates_of(document)) + " as they are in the editor";
    std::string text = "begins with “" + document.active_template()->name + "” as it is in the editor";
    if (count == 2) text += "; the other template of the document stays as it is";
    if (count > 2)
      text += "; the " + std::to_string(count - 1) + " other templates of the document stay as they are";
    return text;
  }
  const LearningRecord& record = *studio.collection.content.learning;
  const std::string start = names_of(record.start);
  if (!record.settled) return "goes on after round " + std::to_string(record.steps.size()) + " from " + start;
  return "begins anew with " + start + ", as it did before; what comes of it takes the place of " +
         (count == 1 ? "the template that was learned"
                     : "the " + plural(count, "template") + " that were learned") +
         ", until Ctrl+Z brings back what was there";
}

void learn(Studio& studio) {
  learn_from(studio, Start::document);
}

void learn_from_shapes_alone(Studio& studio) {
  learn_from(studio, Start::shapes);
}

}  // namespace archetype
