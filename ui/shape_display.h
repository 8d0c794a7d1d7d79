// The shape in view in the form that is drawn: made beside the window, since a large mesh takes its time.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "core/session/latest_worker.h"
#include "render/geometry.h"
#include "ui/shape_in_view.h"

namespace archetype {

// Any of these may be null: the file is gone, or a point set has no faces.
struct ShapeDisplay {
  std::shared_ptr<const MeshGeometry> mesh;
  std::shared_ptr<const PointGeometry> points;  // of a point set: the points of the file
  std::shared_ptr<const PointGeometry> samples;
  std::shared_ptr<const MeshGeometry> coarse;  // of a large mesh, some time after it
  std::uint64_t shape_revision = 0;            // of the ShapeInView that it was made of; 0: nothing yet
};

// Meshes of more triangles than this are drawn coarser while something moves: by a graphics card, and by the
// processor, where 17,000 triangles took a third of a frame.
inline constexpr std::size_t most_moving_triangles = 100'000;
inline constexpr std::size_t most_moving_in_software = 12'000;

struct ShapeDisplayRequest {
  std::shared_ptr<const PolygonMesh> mesh;
  std::shared_ptr<const ShapeSamples> samples;
  ShapeFrame frame;
  std::uint64_t shape_revision = 0;
  std::size_t most_moving = most_moving_triangles;
};

// What the workers run; nothing when cancelled.
std::optional<ShapeDisplay> make_shape_display(const ShapeDisplayRequest& request, const JobControl& control);

struct CoarseMesh {
  std::shared_ptr<const MeshGeometry> mesh;  // its faces are those of the file: the same colours fit
  std::uint64_t shape_revision = 0;
};
// Of half as many triangles as may move. Seconds for half a million triangles.
std::optional<CoarseMesh> make_coarse_mesh(const ShapeDisplayRequest& request, const JobControl& control);

using CoarseMeshWorker = LatestWorker<ShapeDisplayRequest, CoarseMesh>;
using ShapeDisplayWorker = LatestWorker<ShapeDisplayRequest, ShapeDisplay>;

}  // namespace archetype
