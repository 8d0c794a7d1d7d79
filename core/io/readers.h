// The readers behind read_shape, one for each format. Each appends to `shape.mesh` and `shape.warnings` and
// throws InputError as read_shape does; read_shape has done what is common to all and does the last checks.
#pragma once

#include <filesystem>
#include <string_view>

#include "core/io/read_shape.h"

namespace archetype {

struct ShapeBytes {
  std::string_view bytes;
  const std::filesystem::path& path;
};

void read_obj(const ShapeBytes& file, ShapeFile& shape);
void read_off(const ShapeBytes& file, ShapeFile& shape);
void read_ply(const ShapeBytes& file, ShapeFile& shape);
void read_stl(const ShapeBytes& file, ShapeFile& shape);
void read_ac3d(const ShapeBytes& file, ShapeFile& shape);
void read_binvox(const ShapeBytes& file, ShapeFile& shape);
void read_gltf(const ShapeBytes& file, ShapeFile& shape);  // both forms; also adds its buffers to shape.hash
void read_points(const ShapeBytes& file, ShapeFile& shape);  // XYZ and PTS

// Ends the face whose corners were appended to mesh.face_corners one by one.
inline void end_face(PolygonMesh& mesh) {
  mesh.face_begins.push_back(static_cast<std::uint32_t>(mesh.face_corners.size()));
}

}  // namespace archetype
