// A template made of nothing but one shape: what to do with an outlier.
#pragma once

#include "core/io/project.h"

namespace archetype {

struct Studio;

// Segments the shape as a job (section 4.3); what comes of it is added to the document as one step that can
// be undone, and shown on the shape.
void make_template_of_shape(Studio& studio, ShapeId shape);

}  // namespace archetype
