// The part that is selected in the editor and the one that the explorer has picked are one thing: what was
// selected in either is selected in the other once its view is shown.
#pragma once

namespace archetype {

struct Studio;

// Once a frame, before its panels.
void link_selected_part(Studio& studio);

}  // namespace archetype
