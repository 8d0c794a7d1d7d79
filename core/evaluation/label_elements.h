// From labels of samples to labels of the file's faces (section 5, "Segmentation accuracy").
#pragma once

#include <cstdint>
#include <vector>

#include "core/fitting/fit_options.h"
#include "core/geometry/polygon_mesh.h"
#include "core/model/part_template.h"
#include "core/model/shape.h"
#include "core/model/shape_fit.h"

namespace archetype {

// The part index of every face of the file (of every point of a point set), in file order; null_label where
// the fit calls the place an outlier. A cut over the faces where the mesh is usable as a surface, a vote of
// the nearest samples where it is a soup.
std::vector<std::int16_t> label_elements(const PolygonMesh& mesh, const ShapeSamples& samples,
                                         const PartTemplate& part_template, const ShapeFit& fit,
                                         const FitOptions& options);

}  // namespace archetype
