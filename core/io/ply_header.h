// The header of a PLY file: what its body is made of.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/io/readers.h"

namespace archetype {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
std::size_t byte_size(PlyType type);

// What a property means to us; `none` is passed over.
enum class PlyRole { none, x, y, z, nx, ny, nz, face_corners, strip_corners };

struct PlyProperty {
  PlyType type = PlyType::float32;
  std::optional<PlyType> list_count;  // the type of the length, for a list
  PlyRole role = PlyRole::none;
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;

  bool has(PlyRole role) const;
  // The fewest bytes that one record can take in the body.
  std::size_t least_bytes(bool ascii) const;
};

enum class PlyEncoding { ascii, little_endian, big_endian };

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::ascii;
  std::vector<PlyElement> elements;
  std::size_t body_begin = 0;  // byte
  std::size_t body_line = 0;   // number of the body's first line

  std::size_t count(std::string_view element) const;
};

// Throws InputError for a header that is not well formed, lacks the vertices' coordinates or promises more
// than the file holds.
PlyHeader parse_ply_header(const ShapeBytes& file);

}  // namespace archetype
