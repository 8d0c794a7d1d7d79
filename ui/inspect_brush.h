// Painting parts onto the shape in view: what the brush touches is pinned, a stroke is one step.
#pragma once

#include "ui/inspection.h"

namespace archetype {

// The samples within the brush about a point of the shape (normalised coordinates).
std::vector<std::uint32_t> under_brush(const ShapeSamples& samples, const Vec3& point, double radius);

// Goes on with a stroke: `at` is what the mouse points at. A stroke whose preview was dropped, by Esc or
// undo, ends.
void paint(Studio& studio, const std::optional<InspectedPlace>& at);
// The button was let go.
void end_stroke(Studio& studio);

}  // namespace archetype
