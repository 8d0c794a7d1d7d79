// A shape as a picture to click, in the grid and in the clusters.
#pragma once

#include <imgui.h>

#include <string>
#include <vector>

#include "ui/collection.h"
#include "ui/thumbnail_worker.h"

namespace archetype {

struct Studio;

// What the picture of a row has to show now: with the part that is selected, if one is.
WantedThumbnail shown_thumbnail(Studio& studio, const ShapeRow& row);

enum class CellClick {
  none,
  only,    // select this one and show it
  toggle,  // Ctrl: in or out of the selection
  extend,  // Shift: all from the shape in view up to this one
  open     // a double click
};
struct ShapeCell {
  std::string target;            // "TARGET:NAME"
  std::string note;              // beside the name, muted; "" for none
  ImVec2 size;                   // with the name below the picture
  bool offers_template = false;  // a button to make a template from the shape, while the mouse is over it
};
// At the cursor, with its tooltip and its menu.
CellClick draw_shape_cell(Studio& studio, const ShapeRow& row, const ShapeCell& cell);

// Does what the click means. `order` holds the shapes as the cells stand; only `extend` needs it.
void take_click(Studio& studio, CellClick click, ShapeId shape, const std::vector<ShapeId>& order);

// From the shape in view to this one, both included; only this one where the shape in view is not among them.
std::vector<ShapeId> range_of(const std::vector<ShapeId>& order, std::optional<ShapeId> from, ShapeId to);

// In the middle of the window, by itself, with the template that explains it.
void open_shape(Studio& studio, ShapeId shape);

}  // namespace archetype
