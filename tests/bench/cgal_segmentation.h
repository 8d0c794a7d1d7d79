// The segmentation of another library, to compare with.
#pragma once

#include "core/geometry/polygon_mesh.h"

namespace archetype::test {

// CGAL's segmentation_via_sdf_values with its defaults (25 rays, 5 clusters) on a triangle mesh; returns the
// number of segments.
std::size_t cgal_segmentation(const PolygonMesh& mesh);

}  // namespace archetype::test
