// The surface of the shape in view in regions that boxes are made of: its connected components, or the
// segments of an automatic segmentation. Found beside the window.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/geometry/box.h"
#include "core/geometry/polygon_mesh.h"
#include "core/model/shape.h"
#include "core/session/latest_worker.h"

namespace archetype {

enum class RegionKind { component, segment };

struct RegionRequest {
  RegionKind kind = RegionKind::component;
  std::shared_ptr<const PolygonMesh> mesh;  // null, or without faces: all is one component
  std::shared_ptr<const ShapeSamples> samples;
  std::uint64_t shape_revision = 0;
};

struct SurfaceRegions {
  RegionKind kind = RegionKind::component;
  std::uint64_t shape_revision = 0;
  std::vector<std::int16_t> of_sample;  // the region of each; -1 for one that lies in none
  std::vector<Box> boxes;               // per region, in the frame of the shape
};

// How far apart even samples lie, about.
double spacing_of(const ShapeSamples& samples);

// Components have the box of all their corners, along the axes of the shape or, where that is clearly better,
// along their own; components without a sample are left out. Axes that are turned about one axis of the shape
// alone are preferred, for segments too. 0.2 s for a segmentation. Nothing when cancelled.
std::optional<SurfaceRegions> find_surface_regions(const RegionRequest& request, const JobControl& control);

using RegionWorker = LatestWorker<RegionRequest, SurfaceRegions>;

}  // namespace archetype
