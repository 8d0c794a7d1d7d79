// Painting parts onto the shape in view: what the brush touches is pinned, a stroke is one step.
#pragma once

#include "ui/inspect_scene.h"

namespace archetype {

// The samples within the brush about a point of the shape (normalised coordinates).
std::vector<std::uint32_t> under_brush(const ShapeSamples& samples, const Vec3& point, double radius);

// Those of them that no surface hides.
std::vector<std::uint32_t> seen_samples(const InspectContent& content, const Camera& camera,
                                        const Viewport& viewport, const std::vector<std::uint32_t>& samples);

// Goes on with a stroke: `at` is what the mouse points at on what is shown. Only what is seen is painted. A
// stroke whose preview was dropped, by Esc or undo, ends.
void paint(Studio& studio, const InspectContent& content, const Viewport& viewport,
           const std::optional<InspectedPlace>& at);
// The button was let go.
void end_stroke(Studio& studio);

}  // namespace archetype
