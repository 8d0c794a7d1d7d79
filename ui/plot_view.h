// A figure in the window: the same picture as its SVG, with values where the mouse is.
#pragma once

#include <imgui.h>

#include "core/report/plot.h"

namespace archetype {

struct Studio;

// Fills the size; a figure that would be unreadable in it scrolls. Target: "plot".
void draw_plot_view(Studio& studio, const Figure& figure, ImVec2 size);

}  // namespace archetype
