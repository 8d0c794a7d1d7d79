// What lies over the picture of a side while a single fit is inspected: its title, the place that is pointed
// at here or there, the brush, the legend.
#pragma once

#include <imgui.h>

#include <cstddef>

namespace archetype {

struct Studio;

void draw_inspect_overlay(Studio& studio, std::size_t side, ImVec2 origin, ImVec2 size);

}  // namespace archetype
