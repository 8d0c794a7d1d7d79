// From the boxes of one shape to a template that other shapes can be fitted with.
#pragma once

#include "core/learning/segment_shape.h"
#include "core/model/part_template.h"

namespace archetype {

// Deviations and existence of a part before any other shape was seen.
TemplatePart part_from_box(const Box& box);

// "part 1", "part 2", …, with labels 0, 1, …, in the order of the parts.
void name_parts(PartTemplate& part_template);

// One part for each box; only parts with a large share of the samples must exist. Where the shape is its own
// mirror image, so is the template.
PartTemplate template_from_segmentation(const Segmentation& segmentation, const ShapeSamples& samples);

}  // namespace archetype
