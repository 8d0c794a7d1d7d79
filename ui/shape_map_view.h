// The centre view of the map: shapes as dots, and as pictures where there is room; and the sliders beside it.
#pragma once

#include <span>
#include <string>

#include "ui/command.h"
#include "ui/shape_map_state.h"

namespace archetype {

struct Studio;
struct ShapeRow;

void draw_map_tools(Studio& studio);
// Targets: "map" for the whole of it, "map:NAME" for each shape that is drawn as a picture.
void draw_map_view(Studio& studio);

// Sliders for the parameters of a template's part; the boxes follow. Targets: "wish:0" to "wish:5",
// "wish:any:0" …, "wish:reset".
void draw_sliders(Studio& studio, const FitTable& table);
// As many of the shapes nearest to the wishes as fit beside each other. Targets: "near:NAME".
void draw_nearest(Studio& studio);
// What is wished for a part, by script: its name, x|y|z|width|height|depth, deviations or "any".
void wish_command(Studio& studio, Arguments arguments);
// The nearest shapes, found anew if needed.
std::span<const NearShape> use_nearest(Studio& studio, const std::shared_ptr<const FitTable>& table);

// The row of a shape; null where the collection has it no more.
const ShapeRow* map_row(Studio& studio, ShapeId shape);

}  // namespace archetype
