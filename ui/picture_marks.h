// What is picked, marked in the pictures of shapes.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "core/base/picture.h"
#include "core/model/part_colours.h"
#include "render/scene.h"

namespace archetype {

// The number of a part as the colour of a mask; grey and the backdrop are none.
Rgb mask_colour(int part);
// Dims all but one part; `mask` holds the number of the part at each pixel.
void highlight_part(Picture& picture, const Picture& mask, int part);
// Grey on either ground, with a trace of its colour.
Rgb dimmed(const Rgb& colour);
// The colours of faces or samples with all dimmed that are not of the part; one label each. Null stays null.
std::shared_ptr<const Colours> highlighted_colours(std::shared_ptr<const Colours> colours,
                                                   std::span<const std::int16_t> labels, int part);
// A ring about a place, in pixels from the upper left corner: bright in a dark rim.
void draw_ring(Picture& picture, double x, double y);

}  // namespace archetype
