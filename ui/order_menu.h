// Menus of what shapes can be sorted by and shown as histograms.
#pragma once

#include <optional>

#include "core/session/shape_columns.h"

namespace archetype {

struct Studio;

// The items of an open menu or popup; the column that was clicked. `current`, which is ticked, may be null.
// Items are marked as "column:QUANTITY" and "column:QUANTITY:PART".
std::optional<ShapeColumn> draw_column_items(Studio& studio, const ShapeColumn* current, bool with_name);

// A button that says how the shapes are sorted and opens the menu; what is clicked again turns round. Marked
// as "TARGET".
void draw_order_button(Studio& studio, const char* target, float width);

// The order that a person means who sorts by this: energies upwards, sizes and faces downwards.
bool descending_at_first(const ShapeColumn& column);

}  // namespace archetype
