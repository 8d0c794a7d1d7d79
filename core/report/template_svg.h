// A template as a vector picture: sharp in pages of any size.
#pragma once

#include <string>

#include "core/model/part_template.h"

namespace archetype {

// An SVG element of a square of `side` pixels: the mean boxes from the front, right and above, an ellipse for
// the spread of each position and dashed lines for that of each size.
std::string template_svg(const PartTemplate& part_template, int side);

}  // namespace archetype
