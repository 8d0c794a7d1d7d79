// From a polygon soup or point set to the point set that the method works on (section 3, "Template
// definition" and section 5, "Datasets").
#pragma once

#include "core/base/hash.h"
#include "core/base/job_control.h"
#include "core/geometry/polygon_mesh.h"
#include "core/model/shape.h"

namespace archetype {

struct SamplingOptions {
  int points =
      1000;  // samples per shape, 50 to 100,000 (S: a later program of one of the authors uses 1,000)
  UpAxis up = UpAxis::y;   // the file's axis that points up
  std::uint64_t seed = 1;  // mixed with the content hash: a shape has the same samples in every collection
};

// Blue-noise samples by area, upright, straight (straighten.h) and normalised, with normals and features.
// Point sets are thinned to evenly spaced points of the file (fewer than options.points if the file has
// fewer). Throws NumericError if the shape has no area and no points, or its extent is not finite.
ShapeSamples sample_shape(const PolygonMesh& mesh, const ContentHash& hash, const SamplingOptions& options);

}  // namespace archetype
