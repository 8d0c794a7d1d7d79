// Templates that are found in the shapes: suggested from nothing, or learned from a first one. Both run as
// jobs.
#pragma once

#include <cstddef>

namespace archetype {

struct Studio;

// Segments some shapes and shows the templates that come of it, to choose from (section 4.3).
void suggest_templates(Studio& studio);
// Makes it a template of the document; rank < studio.ui.suggestions.size().
void take_suggestion(Studio& studio, std::size_t rank);

// Learns from the active template, or goes on where such a run was stopped (section 4.2). What comes of it
// takes the place of that template, as one step that can be undone; of a stopped run, what its last whole
// round left.
void learn(Studio& studio);

}  // namespace archetype
