// The part that is selected in the editor and the one that the explorer has picked are one thing: what is
// picked in the explorer is selected in the editor, and what was selected while boxes were edited is picked
// once another view is shown.
#pragma once

namespace archetype {

struct Studio;

// Once a frame, before its panels.
void link_selected_part(Studio& studio);

}  // namespace archetype
