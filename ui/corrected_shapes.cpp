#include "ui/corrected_shapes.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/base/sort_unique.h"
#include "core/fitting/fit_options.h"
#include "core/session/current_templates.h"
#include "core/session/fit_collection.h"
#include "core/session/fit_state.h"
#include "ui/project_actions.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

constexpr std::size_t most_former = 200;

// Whose corrections differ.
std::vector<ShapeId> changed_shapes(const std::shared_ptr<const Corrections>& before,
                                    const std::shared_ptr<const Corrections>& after) {
  const Corrections none;
  const Corrections& a = before ? *before : none;
  const Corrections& b = after ? *after : none;
  std::vector<ShapeId> changed;
  const auto look = [&](const Corrections& in, const Corrections& other) {
    for (const auto& [shape, correction] : in) {
      const auto found = other.find(shape);
      if (found == other.end() || !(found->second == correction || *found->second == *correction))
        changed.push_back(shape);
    }
  };
  look(a, b);
  look(b, a);
  sort_unique(changed);
  return changed;
}

ContentHash wanted_state(const ContentHash& state, const Corrections& corrections, ShapeId shape) {
  const auto found = corrections.find(shape);
  return corrected_fit_state(state, found == corrections.end() ? nullptr : found->second.get());
}

// Puts back the fits that were made of the corrections as they are now.
void restore(Project& project, const std::vector<ShapeId>& shapes, const FormerFits& former) {
  const CurrentTemplates current = current_templates(project);
  const ContentHash state = fit_state(current.templates, {});
  const Corrections corrections = project.corrections();
  Project::Transaction transaction(project);
  for (const ShapeId shape : shapes) {
    const ContentHash wanted = wanted_state(state, corrections, shape);
    const auto of_shape = [&](const FormerFit& each) {
      return each.record.shape == shape && each.record.state == wanted &&
             std::ranges::find(current.ids, each.record.part_template) != current.ids.end();
    };
    const auto found = std::find_if(former.rbegin(), former.rend(), of_shape);
    if (found == former.rend()) continue;
    project.store_fit(found->record);
    if (found->labels) project.store_labels(shape, *found->labels);
  }
  transaction.commit();
}

std::string title_of(const Studio& studio, const std::vector<ShapeId>& shapes) {
  const auto row = find_row(studio.collection, shapes.front());
  const bool one = shapes.size() == 1 && row;
  return "Fit " + (one ? studio.collection.rows()[*row].name : plural(shapes.size(), "shape")) +
         " as corrected";
}

void remember(CorrectedShapes& corrected, FormerFits more) {
  FormerFits all = corrected.former ? *corrected.former : FormerFits{};
  std::ranges::move(more, std::back_inserter(all));
  if (all.size() > most_former) all.erase(all.begin(), all.end() - most_former);
  corrected.former = std::make_shared<const FormerFits>(std::move(all));
}

void start(Studio& studio, std::vector<ShapeId> shapes) {
  const auto path = studio.collection.path;
  const auto threads = static_cast<unsigned>(studio.settings.threads);
  const Document document = studio.history.committed();
  const std::shared_ptr<const FormerFits> former = studio.corrected.former;
  const std::string title = title_of(studio, shapes);
  const auto work = [&studio, path, threads, document, former,
                     shapes = std::move(shapes)](const JobControl& control) -> Jobs::Apply {
    Project project = Project::open(path);
    store_corrections(project, document);
    FormerFits before;
    for (const ShapeId shape : shapes)
      if (auto fit = project.fit(shape)) before.push_back({std::move(*fit), project.labels(shape)});
    if (former) restore(project, shapes, *former);
    const FitCollectionReport report = fit_corrected(project, shapes, threads, control);
    return [&studio, path, report, before = std::move(before)]() mutable {
      if (studio.corrected.project == path) remember(studio.corrected, std::move(before));
      for (const RefusedInput& input : report.refused)
        studio.messages.warn(input.path.string() + ": " + input.reason);
      if (report.cancelled)
        say(studio, Severity::note, "Stopped; \"Fit them anew\" beside the inspected fit goes on");
    };
  };
  const JobId job = studio.jobs.start(title, work);
  studio.writers.push_back({.job = job, .project = path, .fits = true});
}

}  // namespace

void follow_corrections(Studio& studio) {
  CorrectedShapes& corrected = studio.corrected;
  const std::shared_ptr<const Corrections>& now = studio.history.committed().corrections;
  if (corrected.project != studio.collection.path) {
    corrected = {.project = studio.collection.path, .seen = now, .waiting = {}, .former = {}};
    return;
  }
  if (corrected.seen != now) {
    std::vector<ShapeId> all;
    std::ranges::set_union(corrected.waiting, changed_shapes(corrected.seen, now), std::back_inserter(all));
    std::erase_if(all, [&](ShapeId shape) {
      const auto row = find_row(studio.collection, shape);
      return !row || !studio.collection.rows()[*row].fit;
    });
    corrected.waiting = std::move(all);
    corrected.seen = now;
  }
  if (corrected.waiting.empty() || studio.history.has_preview() || is_written(studio, corrected.project))
    return;
  start(studio, std::exchange(corrected.waiting, {}));
}

bool corrections_settled(const Studio& studio) {
  const CorrectedShapes& corrected = studio.corrected;
  if (corrected.project != studio.collection.path) return true;
  return corrected.seen == studio.history.committed().corrections &&
         (corrected.waiting.empty() || is_written(studio, corrected.project));
}

}  // namespace archetype
