#include "ui/shape_loader.h"

#include <exception>

#include "core/base/error.h"
#include "core/io/read_shape.h"

namespace archetype {
namespace {

void read_faces(ShapeInView& shape) {
  try {
    ShapeFile file = read_shape(shape.record->path);
    if (file.hash != shape.record->hash)
      shape.problem =
          shape.record->path.string() + " was changed since it was imported; import its folder again";
    else
      shape.mesh = std::make_shared<const PolygonMesh>(std::move(file.mesh));
  } catch (const Error& error) {
    shape.problem = error.what();
  }
}

}  // namespace

std::optional<LoadedShape> load_shape(const LoadShapeRequest& request, const JobControl& control) {
  LoadedShape loaded;
  try {
    const Project project = Project::open(request.project);
    loaded.shape.record = project.find_shape(request.shape);
    if (!loaded.shape.record) return std::nullopt;
    loaded.shape.samples = std::make_shared<const ShapeSamples>(project.samples(request.shape));
    if (control.cancelled()) return std::nullopt;
    read_faces(loaded.shape);
  } catch (const std::exception& error) {
    loaded.shape.problem = error.what();
  }
  return loaded;
}

}  // namespace archetype
