// The panels of the view of a single fit.
#pragma once

namespace archetype {

struct Studio;

void draw_inspect_view(Studio& studio);       // in the middle
void draw_inspect_tools(Studio& studio);      // the line above it
void draw_inspect_panel(Studio& studio);      // at the right: all of the following
void draw_corrections_panel(Studio& studio);  // what else it could be, and what was said of it
void draw_fit_terms_panel(Studio& studio);    // the terms of the energy against the cluster

}  // namespace archetype
