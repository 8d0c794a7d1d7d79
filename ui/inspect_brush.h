// Painting parts onto the shape in view: what the brush touches is pinned, a stroke is one step.
#pragma once

#include <span>

#include "ui/inspect_scene.h"

namespace archetype {

// The samples within the brush about a point of the shape (normalised coordinates).
std::vector<std::uint32_t> under_brush(const ShapeSamples& samples, const Vec3& point, double radius);

// Those of them that no surface hides.
std::vector<std::uint32_t> seen_samples(const InspectContent& content, const Camera& camera,
                                        const Viewport& viewport, const std::vector<std::uint32_t>& samples);

// Where a stroke is painted on its way from where the mouse was in the frame before, `moved` pixels ago: so
// close that it has no gaps and no notches, however quick the hand is. The last is where the mouse is.
std::vector<glm::dvec2> way_of_brush(const glm::dvec2& cursor, const glm::dvec2& moved, double radius);

// Goes on with a stroke: `way` is what the mouse has pointed at on the shape since the last frame. Only what
// is seen is painted. A stroke whose preview was dropped, by Esc or undo, ends.
void paint(Studio& studio, const InspectContent& content, const Viewport& viewport,
           std::span<const InspectedPlace> way);
// The button was let go.
void end_stroke(Studio& studio);

}  // namespace archetype
