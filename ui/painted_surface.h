// What the brush has painted, as smooth patches on the surface: faces may be much larger than a stroke, and
// samples lie too far apart for its edge.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/fitting/pinned_labels.h"
#include "core/model/shape_fit.h"
#include "render/geometry.h"

namespace archetype {

struct PaintedPatch {
  std::int16_t label = null_label;
  std::shared_ptr<const MeshGeometry> geometry;  // a little above the surface, on either side
};

// The parts of the surface whose samples nearby are mostly pinned to one label, a patch for each label. The
// pins' samples are indices into `samples`, both in the coordinates of the mesh. A few milliseconds for a
// stroke; where very much is painted, its edge becomes coarser.
std::vector<PaintedPatch> painted_patches(const MeshGeometry& mesh, const PointGeometry& samples,
                                          std::span<const PinnedLabel> pinned);

}  // namespace archetype
