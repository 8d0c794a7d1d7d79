// Suggests templates for the shapes of a project (section 4.3).
#pragma once

#include "core/base/job_control.h"
#include "core/io/project.h"
#include "core/learning/initial_templates.h"

namespace archetype {

struct SuggestOptions {
  std::size_t segmented_shapes = 30;  // K, at least 1: shapes that are segmented, chosen by the seed
  std::size_t scored_shapes = 60;     // shapes that every candidate is fitted to, at least 1
  std::uint64_t seed = 1;
  InitialTemplateOptions initial;
};

struct Suggestions {
  std::vector<InitialTemplate> templates;  // the best first
  std::size_t segmented = 0;               // shapes
  std::size_t scored = 0;
  bool cancelled = false;
};

// Holds the samples of the chosen shapes only, however many the project has. The project is not changed. Its
// shapes count in the order of their names: the order of import does not matter, nor does the number of
// threads. Throws PreconditionError if the project has no shape.
Suggestions suggest_templates(const Project& project, const SuggestOptions& options, unsigned threads,
                              const JobControl& control);

// Stores those that the project does not have yet, and makes the one at `chosen` its current template.
void store_suggestions(Project& project, const std::vector<PartTemplate>& suggested, std::size_t chosen);

}  // namespace archetype
