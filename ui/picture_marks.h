// What is picked, marked in the pictures of shapes.
#pragma once

#include "core/base/picture.h"
#include "core/model/part_colours.h"

namespace archetype {

// The number of a part as the colour of a mask; grey and the backdrop are none.
Rgb mask_colour(int part);
// Dims all but one part; `mask` holds the number of the part at each pixel.
void highlight_part(Picture& picture, const Picture& mask, int part);
// A ring about a place, in pixels from the upper left corner: bright in a dark rim.
void draw_ring(Picture& picture, double x, double y);

}  // namespace archetype
