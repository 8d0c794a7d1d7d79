// Reading a shape, whatever its format: OBJ, OFF, PLY, STL, glTF, GLB, AC3D; point sets as PLY, XYZ, PTS and
// binvox.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/hash.h"
#include "core/geometry/polygon_mesh.h"

namespace archetype {

struct ShapeFile {
  PolygonMesh mesh;
  ContentHash hash;                   // of the file itself (and of the buffers that a glTF refers to)
  std::vector<std::string> warnings;  // what was sloppy and read all the same, a line each
};

// Whether the ending is one of a format that read_shape knows (case does not matter).
bool has_shape_ending(const std::filesystem::path& path);

// Throws InputError (path, line or byte, what was expected) for content that cannot be read, FileError if the
// file cannot be opened. Never takes more than a small multiple of the file's size in memory, never reads
// outside the file's folder. Thread-safe; does not depend on the locale.
ShapeFile read_shape(const std::filesystem::path& path);

}  // namespace archetype
