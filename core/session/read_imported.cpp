// Reads and compares what was read with what the project knows.
#include "core/session/read_imported.h"

#include "core/base/error.h"
#include "core/io/read_shape.h"

namespace archetype {

PolygonMesh read_imported(const ShapeRecord& shape) {
  ShapeFile file = read_shape(shape.path);
  if (file.hash != shape.hash || file.mesh.element_count() != shape.element_count) {
    throw InputError(shape.path, "", "has changed since it was imported; import it again");
  }
  return std::move(file.mesh);
}

}  // namespace archetype
