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

// What learn() makes of the templates of a document.
struct Beginning {
  std::vector<PartTemplate> start;
  std::vector<std::size_t> replaced;  // those of the document that what is learned takes the place of
  bool goes_on = false;               // with the rounds that the project tells of
};

// Where `wanted` are among those of the document, ascending; nothing if some are not.
std::optional<std::vector<std::size_t>> places_of(const std::vector<PartTemplate>& wanted,
                                                  const std::vector<PartTemplate>& of_document) {
  std::vector<std::size_t> places;
  for (const PartTemplate& each : wanted) {
    const auto found = std::ranges::find(of_document, each);
    if (found == of_document.end()) return std::nullopt;
    places.push_back(static_cast<std::size_t>(found - of_document.begin()));
  }
  std::ranges::sort(places);
  return places;
}

std::vector<PartTemplate> newest_of(const LearningRecord& record) {
  std::vector<PartTemplate> newest;
  if (record.steps.empty()) return newest;
  for (const TemplateId id : record.steps.back().templates) newest.push_back(*find_learned(record, id));
  return newest;
}

// With what the newest of the project's rounds came from, where the document holds its templates: those of a
// stopped learning also beside others. Else with all templates of the document where these are the project's
// current ones, or what its learning began with (that is undone, and shall be done again). Else with the
// active one. record: null if nothing was learned. can_go_on: as in learn_templates.h.
Beginning beginning(const Document& document, const std::vector<PartTemplate>& current,
                    const LearningRecord* record, bool can_go_on) {
  const std::vector<PartTemplate> of_document = templates_of(document);
  Beginning result;
  if (record && can_go_on && !record->steps.empty()) {
    auto places = places_of(newest_of(*record), of_document);
    const bool all = places && places->size() == of_document.size();
    if (places && (all || (!is_over(*record, {}) && std::ranges::binary_search(*places, document.active))))
      return {record->start, std::move(*places), true};
  }
  if (of_document == current || (record && of_document == record->start)) {
    result.start = of_document;
    for (std::size_t i = 0; i < of_document.size(); ++i) result.replaced.push_back(i);
  } else if (const PartTemplate* active = document.active_template()) {
    result = {{*active}, {document.active}};
  }
  // What was learned from other shapes, or with other corrections, is learned anew from where it began.
  if (record && result.start == newest_of(*record)) result.start = record->start;
  result.goes_on = record && can_go_on && !record->steps.empty() && result.start == record->start;
  return result;
}

Beginning beginning(const Studio& studio) {
  const CollectionRows& content = studio.collection.content;
  const Document& document = studio.history.committed();
  // Autosave may be behind, and the rows may.
  const bool as_corrected = same_corrections(document.corrections, content.corrections);
  return beginning(document, content.templates, content.learning.get(),
                   content.learning_can_go_on && as_corrected);
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
  std::string title = "Learn from the shapes alone";
  if (from == Start::document) {
    title = "Learn from " + beginning(studio).start.front().name;
    say(studio, Severity::note, "Learning: " + what_learning_begins_with(studio));
  }
  const JobId job = studio.jobs.start(
      title, [&studio, path, threads, document, from, title](const JobControl& control) -> Jobs::Apply {
        Project project = Project::open(path);
        store_corrections(project, document);
        const auto record = learning_record(project);
        Beginning begun;
        if (from == Start::shapes) {
          const auto chosen = automatic_start(project, {}, {}, learning_seed, false, threads, control);
          if (!chosen) return {};
          begun.start = {*chosen};
          // What was learned from it so far is there already.
          if (record && record->start == begun.start)
            begun.replaced =
                places_of(newest_of(*record), templates_of(document)).value_or(std::vector<std::size_t>{});
        } else {
          begun = beginning(document, current_templates(project).templates, record ? &*record : nullptr,
                            can_go_on(project, {}, {}, learning_seed));
        }
        const LearnReport report =
            learn_templates(project, begun.start, {}, {}, learning_seed, false, threads, control);
        // Not the current ones of a learning that was stopped: others may have been fitted since its last
        // round.
        std::vector<PartTemplate> learned;
        if (report.steps.empty()) {
          learned = current_templates(project).templates;
        } else {
          for (const TemplateId id : report.steps.back().templates)
            learned.push_back(project.find_template(id).value().part_template);
        }
        return [&studio, path, document, from, replaced = begun.replaced, report, learned, title] {
          if (studio.collection.path != path) return;
          const bool nothing = report.cancelled && report.steps.empty();
          if (nothing)
            return say(studio, Severity::note,
                       from == Start::document
                           ? "Learning stopped before the end of a round; nothing was changed"
                           : "Learning stopped before the end of a round; what the shapes suggest is kept");
          // A template that was edited meanwhile stays; what was learned comes beside it.
          const auto& now = studio.history.committed().templates;
          const bool same = std::ranges::all_of(
              replaced, [&](std::size_t i) { return i < now.size() && now[i] == document.templates[i]; });
          take_learned(studio.history, learned, same ? replaced : std::vector<std::size_t>{}, title);
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
  const Beginning begins = beginning(studio);
  const std::string start = names_of(begins.start);
  const LearningRecord* record = studio.collection.content.learning.get();
  const auto in_editor = [&](const std::vector<PartTemplate>& templates) {
    return places_of(templates, templates_of(document)).has_value();
  };
  if (begins.goes_on) {
    const std::string rounds = plural(record->steps.size(), "round");
    if (!is_over(*record, {}))
      return "goes on after round " + std::to_string(record->steps.size()) + " from " + start;
    if (in_editor(newest_of(*record)))
      return "has nothing left to do from " + start + " after " + rounds +
             "; shapes that lack a fit of what was learned get one";
    return "brings back what " + start + " became in " + rounds + ": nothing is left to do after them";
  }
  const std::size_t replaced = begins.replaced.size();
  if (!in_editor(begins.start))
    return "begins anew with " + start +
           ", as what was learned is of other shapes, corrections or options; what comes of it takes the "
           "place of " +
           (replaced == 1 ? "the template that was learned"
                          : "the " + plural(replaced, "template") + " that were learned") +
           ", until Ctrl+Z brings back what was there";
  std::string text = "begins with " + start;
  text += begins.start.size() > 1 ? " as they are in the editor" : " as it is in the editor";
  const std::size_t others = document.templates.size() - replaced;
  if (others == 1) text += "; the other template of the document stays as it is";
  if (others > 1)
    text += "; the " + std::to_string(others) + " other templates of the document stay as they are";
  return text;
}

bool learning_goes_on(const Studio& studio) {
  const Beginning begins = beginning(studio);
  return begins.goes_on && !is_over(*studio.collection.content.learning, {});
}

void learn(Studio& studio) {
  learn_from(studio, Start::document);
}

void learn_from_shapes_alone(Studio& studio) {
  learn_from(studio, Start::shapes);
}

}  // namespace archetype
