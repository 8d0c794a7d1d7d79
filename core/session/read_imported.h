// The faces of a shape of the project, from where it was imported.
#pragma once

#include "core/geometry/polygon_mesh.h"
#include "core/io/project.h"

namespace archetype {

// Throws InputError if the file is gone, cannot be read or is not the one that was imported.
PolygonMesh read_imported(const ShapeRecord& shape);

}  // namespace archetype
