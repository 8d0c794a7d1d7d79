// How badly the template explains each sample, as colours with a legend.
#pragma once

#include <imgui.h>

#include <memory>
#include <span>

#include "render/scene.h"
#include "ui/fonts.h"
#include "ui/theme.h"

namespace archetype {

// Costs (see sample_costs()) from 0 to this one are told apart; it is that of a point as far from its part as
// is bad.
inline constexpr double largest_heat = 1;

// From dark blue over red to light yellow, each lighter than the one before, so that it can be read without
// telling hues apart (after "inferno" of matplotlib).
Rgb heat_colour(double share);
std::shared_ptr<const Colours> heat_colours(std::span<const double> costs);
std::shared_ptr<const Colours> heat_colours(std::span<const float> costs);

// In the lower right corner of a view.
void draw_heat_legend(ImDrawList& draw, const Fonts& fonts, const Palette& palette, ImVec2 corner);

}  // namespace archetype
