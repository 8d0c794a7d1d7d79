// The mouse at the spread of the selected part.
#pragma once

#include <imgui.h>

#include "ui/viewport_mouse.h"

namespace archetype {

// Drags the dots of the selected part while view.spread is on: live edits, then one step. True if it has the
// mouse; then nobody else shall follow it.
bool follow_spread(Studio& studio, const MouseInput& mouse, const GizmoView& view);

// The dots, and the number that is dragged.
void draw_spread_dots(const Studio& studio, ImDrawList& draw, ImVec2 origin, const GizmoView& view);

}  // namespace archetype
