// Templates that are found in the shapes: suggested from nothing, or learned from a first one. Both run as
// jobs.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "core/session/jobs.h"

namespace archetype {

struct Studio;

// Segments some shapes and shows the templates that come of it, to choose from (section 4.3).
void suggest_templates(Studio& studio);
// Makes it a template of the document; rank < studio.ui.suggestions.size().
void take_suggestion(Studio& studio, std::size_t rank);

// Learns from the active template, or from all where these are the project's, or goes on where such a run was
// stopped (section 4.2). What comes of it takes the place of these, or of what that run had left, as one step
// that can be undone; of a stopped run, what its last whole round left.
void learn(Studio& studio);
// What that begins with now, and what becomes of what is there: for a person. There is an active template.
std::string what_learning_begins_with(const Studio& studio);
// Whether rounds follow on those that the project tells of. There is an active template.
bool learning_goes_on(const Studio& studio);
// The same without a template to begin with: learns a little from each of those that the shapes suggest, and
// on from the best (section 4.3). What comes of it is put beside the templates of the document. A stopped
// choice is gone on with.
void learn_from_shapes_alone(Studio& studio);
// The job that learns from the collection in view.
std::optional<JobView> learning_job(const Studio& studio);
// The whole rounds that the project in view holds.
std::size_t rounds_learned(const Studio& studio);
// How long the rounds take that are still allowed, if they go on as those of the job so far; nothing before
// its first one is whole. Learning mostly settles sooner.
std::optional<double> most_seconds_of_rounds(const Studio& studio);
// Looks at a template of a round (0: what learning began with), which becomes the chosen one of the learning
// panel. Throws Error where there is no such template.
void look_into_round(Studio& studio, std::size_t round, std::size_t part_template);
// Brings the learning panel into sight, high enough to be of use.
void show_learning(Studio& studio);

}  // namespace archetype
