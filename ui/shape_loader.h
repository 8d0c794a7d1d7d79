// Reads the shape to be shown beside the window.
#pragma once

#include <filesystem>
#include <optional>

#include "core/session/latest_worker.h"
#include "ui/shape_in_view.h"

namespace archetype {

struct LoadShapeRequest {
  std::filesystem::path project;
  ShapeId shape = 0;
};

struct LoadedShape {
  ShapeInView shape;  // without revisions
};

// Samples from the project, faces from the file. A file that is gone or was changed is a problem, not an
// error: the shape is shown by its samples then.
std::optional<LoadedShape> load_shape(const LoadShapeRequest& request, const JobControl& control);

using ShapeLoader = LatestWorker<LoadShapeRequest, LoadedShape>;

}  // namespace archetype
