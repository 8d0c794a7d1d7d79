// STL, ASCII and binary. The format repeats the corners in every facet; those at exactly the same place
// become one vertex, so that faces have neighbours. Facet normals are passed over: many files have none, or
// wrong ones.
#include <array>
#include <bit>
#include <cstring>

#include "core/base/error.h"
#include "core/io/readers.h"
#include "core/io/text_cursor.h"
#include "core/io/vertex_welder.h"

namespace archetype {
namespace {

constexpr std::size_t header_bytes = 84;
constexpr std::size_t facet_bytes = 50;

std::uint32_t little_endian_word(const char* bytes) {
  std::uint32_t word = 0;
  for (int i = 3; i >= 0; --i) word = word << 8 | static_cast<unsigned char>(bytes[i]);
  return word;
}

// A binary file may begin with "solid" too, so its length decides, and then whether the word "facet" follows.
bool is_binary(std::string_view bytes) {
  if (bytes.size() >= header_bytes &&
      bytes.size() == header_bytes + facet_bytes * std::size_t{little_endian_word(bytes.data() + 80)}) {
    return true;
  }
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  bytes.remove_prefix(std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size()));
  const bool solid = equals_ignoring_case(bytes.substr(0, 5), "solid");
  return !solid || bytes.find('\0') != bytes.npos;
}

void read_binary(const ShapeBytes& file, ShapeFile& shape) {
  const std::size_t size = file.bytes.size();
  if (size < header_bytes) {
    throw InputError(
        file.path, "",
        "expected STL: \"solid\", or a binary header of 84 bytes; the file has " + std::to_string(size));
  }
  const std::size_t facets = little_endian_word(file.bytes.data() + 80);
  if (facets > (size - header_bytes) / facet_bytes) {
    throw InputError(file.path, "byte 80",
                     "the header promises " + std::to_string(facets) + " facets of 50 bytes, but only " +
                         std::to_string(size - header_bytes) +
                         " bytes follow; the file is cut off or is no STL");
  }
  if (facets == 0) throw InputError(file.path, "byte 80", "the file holds no facets");
  if (size != header_bytes + facet_bytes * facets)
    shape.warnings.emplace_back("bytes after the last facet are not read");

  VertexWelder welder(shape.mesh.vertices, facets * 3);
  shape.mesh.face_corners.reserve(facets * 3);
  shape.mesh.face_begins.reserve(facets + 1);
  for (std::size_t f = 0; f < facets; ++f) {
    const std::size_t begin = header_bytes + f * facet_bytes;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      Vec3 vertex;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const char* bytes = file.bytes.data() + begin + 12 * (corner + 1) + 4 * axis;
        vertex[static_cast<Eigen::Index>(axis)] = std::bit_cast<float>(little_endian_word(bytes));
      }
      if (!vertex.allFinite()) {
        throw InputError(file.path, "byte " + std::to_string(begin + 12 * (corner + 1)),
                         "a coordinate is not a finite number");
      }
      shape.mesh.face_corners.push_back(welder.add(vertex));
    }
    end_face(shape.mesh);
  }
}

void read_ascii(const ShapeBytes& file, ShapeFile& shape) {
  TextCursor cursor(file.bytes, file.path, {.comments = false});
  PolygonMesh& mesh = shape.mesh;
  VertexWelder welder(mesh.vertices, file.bytes.size() / 80);
  bool in_facet = false;
  bool ended = false;
  std::size_t odd_facets = 0;
  for (std::string_view word = cursor.word_in_file(); !word.empty(); word = cursor.word_in_file()) {
    const auto is = [&](std::string_view key) { return equals_ignoring_case(word, key); };
    if (is("vertex") && in_facet) {
      Vec3 vertex;
      for (int axis = 0; axis < 3; ++axis) vertex[axis] = cursor.number();
      mesh.face_corners.push_back(welder.add(vertex));
    } else if (is("facet") && !in_facet) {
      in_facet = true;
    } else if (is("endfacet") && in_facet) {
      odd_facets += mesh.face_corners.size() - mesh.face_begins.back() != 3 ? 1 : 0;
      end_face(mesh);
      in_facet = false;
    } else if (is("normal") && in_facet) {
      for (int axis = 0; axis < 3; ++axis) cursor.word();  // not looked at: "nan nan nan" is common
    } else if ((is("solid") || is("endsolid")) && !in_facet) {
      cursor.rest_of_line();
      ended = is("endsolid");
    } else if (!(in_facet && (is("outer") || is("loop") || is("endloop")))) {
      cursor.fail(std::string("expected ") + (in_facet ? "vertex or endfacet" : "facet or endsolid") +
                  ", found " + quote(word));
    }
  }
  if (in_facet) cursor.fail("the file ends within a facet; it is cut off");
  if (mesh.face_count() == 0) cursor.fail("the file holds no facets");
  if (!ended) shape.warnings.emplace_back("endsolid is missing; the file may be cut off");
  if (odd_facets > 0) {
    shape.warnings.push_back(std::to_string(odd_facets) + " facets have other than three corners");
  }
}

}  // namespace

void read_stl(const ShapeBytes& file, ShapeFile& shape) {
  if (is_binary(file.bytes)) {
    read_binary(file, shape);
  } else {
    read_ascii(file, shape);
  }
}

}  // namespace archetype
