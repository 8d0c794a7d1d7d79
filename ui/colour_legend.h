// What the colours of a view mean.
#pragma once

#include <imgui.h>

#include <string>
#include <vector>

#include "core/model/part_colours.h"
#include "ui/fonts.h"
#include "ui/theme.h"

namespace archetype {

// A colour map from 0 to its end, with heat_colour().
struct ColourScale {
  std::string title;
  std::string middle;
  std::string most;
};

struct ColourName {
  Rgb colour;
  std::string name;
};

// Both stand in the lower right corner of a view.
void draw_colour_scale(ImDrawList& draw, const Fonts& fonts, const Palette& palette, ImVec2 corner,
                       const ColourScale& scale);
// As many as there is `height` for; the last line says how many are left out.
void draw_colour_names(ImDrawList& draw, const Fonts& fonts, const Palette& palette, ImVec2 corner,
                       float height, const std::vector<ColourName>& names);

}  // namespace archetype
