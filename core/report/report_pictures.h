// Pictures of shapes for the report, on machines without OpenGL too.
#pragma once

#include "core/io/project.h"
#include "core/report/html_report.h"

namespace archetype {

// Samples as discs in the colours of their parts (grey without a fit), from three quarters, on a transparent
// ground of `side` pixels. About 1 ms for 1,000 samples.
Picture sample_picture(const ShapeSamples& samples, const PartTemplate* part_template, const ShapeFit* fit,
                       int side);

// The thumbnail that the project keeps of the fitted shape, or else what `draw` draws, or else the picture of
// its samples. Throws FileError.
Picture report_picture(const Project& project, ShapeId shape, int side, const DrawShape& draw);

}  // namespace archetype
