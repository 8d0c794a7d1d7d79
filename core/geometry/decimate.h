// Coarser meshes for drawing while something moves.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/job_control.h"
#include "core/geometry/polygon_mesh.h"

namespace archetype {

struct DecimatedMesh {
  PolygonMesh mesh;  // triangles, in the coordinates of the original
  std::vector<std::uint32_t>
      faces;  // of each triangle, the face of the original that it stands for: its label, its colour
};

// Collapses edges by their quadric error (Garland and Heckbert 1997) until about `triangle_count` triangles
// are left. Triangles that share an edge with two others already are cut loose from it, so that soups can be
// taken as they are; a soup of many loose pieces may keep more triangles than asked for. Nothing if
// cancelled. Deterministic; about 10 s for 500,000 triangles.
std::optional<DecimatedMesh> decimate(const PolygonMesh& mesh, std::size_t triangle_count,
                                      const JobControl& control = {});

}  // namespace archetype
