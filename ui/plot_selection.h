// Plots select too: a bar stands for shapes, or for a part.
#pragma once

#include <imgui.h>

#include <span>

#include "core/report/plot_drawing.h"

namespace archetype {

struct Studio;

// The shapes that a value of the figure stands for; empty where it stands for none.
std::span<const ShapeId> shapes_of(const Figure& figure, const HoverValue& value);
// Selects them, or adds them to the selection, and picks the part that the value is of.
void select_value(Studio& studio, const Figure& figure, const HoverValue& value, bool add);
// What a click would do, for the tooltip; "" where it would do nothing.
std::string selection_hint(const Studio& studio, const Figure& figure, const HoverValue& value);
// Over the bars: the share of their shapes that is selected, and a frame about those that hold the shape
// under the mouse in whichever panel, or the shape in view.
void draw_selected_shares(const Studio& studio, const Figure& figure, const PlotDrawing& drawing,
                          ImVec2 origin);

}  // namespace archetype
