// Finds the reader for a file, and checks what all formats have in common.
#include "core/io/read_shape.h"

#include <algorithm>
#include <array>
#include <span>

#include "core/base/error.h"
#include "core/io/file.h"
#include "core/io/readers.h"
#include "core/io/text_cursor.h"

namespace archetype {
namespace {

struct Format {
  std::string_view ending;  // lower case
  bool text;                // never holds a byte 0 (OFF has a binary form, which its reader names)
  void (*read)(const ShapeBytes&, ShapeFile&);
};

constexpr std::array formats = {
    Format{".obj", true, read_obj},    Format{".off", false, read_off},
    Format{".ply", false, read_ply},   Format{".stl", false, read_stl},
    Format{".gltf", true, read_gltf},  Format{".glb", false, read_gltf},
    Format{".xyz", true, read_points}, Format{".pts", true, read_points},
    Format{".ac", true, read_ac3d},    Format{".binvox", false, read_binvox},
};

const Format* find_format(const std::filesystem::path& path) {
  const std::string ending = path.extension().string();
  const auto* found = std::ranges::find_if(
      formats, [&](const Format& format) { return equals_ignoring_case(ending, format.ending); });
  return found == formats.end() ? nullptr : found;
}

// How contents begin that often stand under a wrong name.
struct Signature {
  std::string_view begin;
  std::string_view ending;  // of the format; empty if it is none that can be read
  const char* name;
};

constexpr std::array signatures = {
    Signature{"ply\n", ".ply", "PLY"},
    Signature{"ply\r", ".ply", "PLY"},
    Signature{"glTF", ".glb", "binary glTF"},
    Signature{"#binvox", ".binvox", "binvox"},
    Signature{"AC3D", ".ac", "AC3D"},
    Signature{"\x89PNG", "", "a PNG picture"},
    Signature{"\xFF\xD8\xFF", "", "a JPEG picture"},
    Signature{"PK\x03\x04", "", "a ZIP archive; unpack it first"},
    Signature{"\x1F\x8B", "", "gzip data; unpack it first"},
    Signature{"%PDF", "", "a PDF document"},
    Signature{"SQLite format 3", "", "an SQLite database"},
    Signature{"<!DOCTYPE", "", "a web page"},
    Signature{"<html", "", "a web page"},
    Signature{"<?xml", "", "XML"},
    Signature{"version https://git-lfs", "", "a Git LFS pointer, not the file itself"},
};

void refuse_wrong_content(const ShapeBytes& file, const Format& format) {
  if (file.bytes.empty()) throw InputError(file.path, "", "the file is empty");
  for (const Signature& signature : signatures) {
    if (!file.bytes.starts_with(signature.begin) || signature.ending == format.ending) continue;
    throw InputError(
        file.path, "byte 0",
        "the name ends in " + std::string(format.ending) + ", but the content is " + signature.name);
  }
  if (!format.text) return;
  const std::size_t zero = file.bytes.find('\0');
  if (zero != file.bytes.npos) {
    throw InputError(file.path, "byte " + std::to_string(zero),
                     "expected text, as " + std::string(format.ending) + " files are, found binary data");
  }
}

// Beyond it, squares of areas are no longer finite; nothing is that large in any unit.
constexpr double largest_coordinate = 1e30;

void check_vertices(const ShapeFile& shape, const std::filesystem::path& path) {
  const std::vector<Vec3>& vertices = shape.mesh.vertices;
  if (vertices.empty()) throw InputError(path, "", "the file holds no vertices");
  const auto far = std::ranges::find_if(
      vertices, [](const Vec3& v) { return !(v.array().abs() <= largest_coordinate).all(); });
  if (far == vertices.end()) return;
  throw InputError(path, "vertex " + std::to_string(far - vertices.begin() + 1),
                   "a coordinate is beyond 1e30, too large to compute with");
}

// Faces that span no polygon are kept, since labels are counted by them, but said.
void warn_about_degenerate_faces(ShapeFile& shape) {
  std::size_t degenerate = 0;
  for (std::size_t f = 0; f < shape.mesh.face_count(); ++f) {
    const std::span<const std::uint32_t> face = shape.mesh.face(f);
    bool repeats = face.size() < 3;
    for (std::size_t i = 0; i < face.size(); ++i) repeats |= face[i] == face[(i + 1) % face.size()];
    degenerate += repeats ? 1 : 0;
  }
  if (degenerate == 0) return;
  shape.warnings.push_back(std::to_string(degenerate) + " of " + std::to_string(shape.mesh.face_count()) +
                           " faces have fewer than three corners or repeat one; they are kept");
}

}  // namespace

bool has_shape_ending(const std::filesystem::path& path) {
  return find_format(path) != nullptr;
}

ShapeFile read_shape(const std::filesystem::path& path) {
  const Format* format = find_format(path);
  if (format == nullptr) {
    std::string endings;
    for (const Format& known : formats) endings.append(" ").append(known.ending);
    throw InputError(path, "", "the ending is of no format that can be read; expected one of" + endings);
  }
  const std::string content = read_file(path);
  const ShapeBytes file{content, path};
  refuse_wrong_content(file, *format);

  ShapeFile shape;
  shape.hash = hash_content(std::as_bytes(std::span(content)));
  format->read(file, shape);
  check_vertices(shape, path);
  if (!shape.mesh.is_point_set()) shape.mesh.point_normals.clear();
  warn_about_degenerate_faces(shape);
  return shape;
}

}  // namespace archetype
