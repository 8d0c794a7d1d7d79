// The filter: which shapes are shown, by templates, status, parts and ranges of numbers.
#pragma once

namespace archetype {

struct Studio;

// Opens the panel, and says how many conditions there are. Marked as "command:show-filter".
void draw_filter_button(Studio& studio, float width);
void draw_filter_panel(Studio& studio);
// Brings the panel into sight, high enough to be of use.
void show_filter(Studio& studio);

}  // namespace archetype
