// Chooses shapes, loads their samples and stores what comes out.
#include "core/session/suggest_templates.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/session/learning_corrections.h"

namespace archetype {

namespace {

// The position of each in `all`, which holds them in increasing order.
std::vector<std::size_t> positions(const std::vector<std::size_t>& chosen,
                                   const std::vector<std::size_t>& all) {
  std::vector<std::size_t> result;
  result.reserve(chosen.size());
  for (const std::size_t i : chosen)
    result.push_back(static_cast<std::size_t>(std::ranges::lower_bound(all, i) - all.begin()));
  return result;
}

}  // namespace

Suggestions suggest_templates(const Project& project, const SuggestOptions& options, unsigned threads,
                              const JobControl& control) {
  const std::vector<ShapeId> ids = LearningCorrections(project).without_outliers(project.shape_ids());
  if (ids.empty()) throw PreconditionError("templates can only be suggested for a project that has shapes");
  const auto segmented = random_subset(ids.size(), options.segmented_shapes, derive_seed(options.seed, 0));
  const auto scored = random_subset(ids.size(), options.scored_shapes, derive_seed(options.seed, 1));
  std::vector<std::size_t> needed;
  std::ranges::set_union(segmented, scored, std::back_inserter(needed));
  Suggestions result;
  InitialShapes shapes;
  for (const std::size_t i : needed) {
    result.cancelled = control.cancelled();
    if (result.cancelled) return result;
    shapes.names.push_back(project.find_shape(ids[i]).value().name);
    shapes.samples.push_back(project.samples(ids[i]));
    control.progress(shapes.names.size(), needed.size(), "loading");
  }
  shapes.segmented = positions(segmented, needed);
  shapes.scored = positions(scored, needed);
  InitialTemplateOptions initial = options.initial;
  initial.segmentation.seed = derive_seed(options.seed, 2);
  std::optional<std::vector<InitialTemplate>> found = initial_templates(shapes, initial, threads, control);
  result.cancelled = !found;
  if (found) result.templates = std::move(*found);
  result.segmented = segmented.size();
  result.scored = scored.size();
  return result;
}

void store_suggestions(Project& project, const std::vector<PartTemplate>& suggested, std::size_t chosen) {
  Project::Transaction transaction(project);
  const std::vector<TemplateRecord> known = project.templates(false);
  std::vector<TemplateId> ids;
  for (const PartTemplate& suggestion : suggested) {
    const auto same = std::ranges::find(known, suggestion, &TemplateRecord::part_template);
    if (same != known.end()) {
      ids.push_back(same->id);
      continue;
    }
    TemplateRecord record;
    record.part_template = suggestion;
    record.current = false;
    ids.push_back(project.add_template(record));
  }
  project.set_current_templates({ids.at(chosen)});
  transaction.commit();
}

}  // namespace archetype
