// A template as a small picture of its boxes, for lists to choose from.
#pragma once

#include <imgui.h>

#include "core/model/part_template.h"
#include "core/model/shape.h"
#include "core/model/shape_fit.h"

namespace archetype {

// Into the square of `side` screen units whose upper left corner is `low`, seen from the front, right and
// above, each box in the colour of its part. With the samples of a shape and the fit of the template to it,
// also these, in the colours of the parts that they belong to, with the boxes as they were fitted.
void draw_template_picture(ImDrawList& draw, const PartTemplate& part_template, ImVec2 low, float side);
void draw_fit_picture(ImDrawList& draw, const ShapeFit& fit, const ShapeSamples& samples, ImVec2 low,
                      float side);

}  // namespace archetype
