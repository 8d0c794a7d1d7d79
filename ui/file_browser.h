// Choosing files and folders inside the window: no dialog program has to be installed.
#pragma once

#include "ui/ui_state.h"

namespace archetype {

struct Studio;

// Opens the browser where the user was last.
void browse(Studio& studio, const BrowseFor& wanted);
void draw_file_browser(Studio& studio);

}  // namespace archetype
