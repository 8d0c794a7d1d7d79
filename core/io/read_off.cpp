// Object File Format, text form, with what is met in the wild: any of the prefixes ST, C, N and 4 (whose
// values are passed over, but for the normals of a point set), the header glued to the counts, or no header
// at all.
#include "core/base/error.h"
#include "core/io/readers.h"
#include "core/io/text_cursor.h"

namespace archetype {
namespace {

struct Header {
  bool normals = false;
  bool homogeneous = false;
  std::int64_t vertices = 0;
  std::int64_t faces = 0;
};

// Takes "STCN4OFF" apart; what is glued to it stays in `rest`.
Header parse_magic(std::string_view word, std::string_view& rest, const TextCursor& cursor) {
  Header header;
  rest = word;
  const auto take = [&](std::string_view prefix) {
    const bool found = rest.starts_with(prefix);
    if (found) rest.remove_prefix(prefix.size());
    return found;
  };
  take("ST");
  take("C");
  header.normals = take("N");
  header.homogeneous = take("4");
  if (rest.starts_with("nOFF")) cursor.fail("OFF of other than three dimensions (nOFF) is not supported");
  if (!take("OFF") && !take("off"))
    cursor.fail("expected OFF or the number of vertices, found " + quote(word));
  return header;
}

// The header and the three counts, over one line or several.
Header read_header(TextCursor& cursor, ShapeFile& shape) {
  cursor.require_line("OFF");
  std::string_view word = cursor.word();
  Header header;
  std::int64_t number = 0;
  if (parse_integer(word, number)) {
    shape.warnings.emplace_back("the header OFF is missing");
  } else {
    std::string_view rest;
    header = parse_magic(word, rest, cursor);
    word = rest.empty() ? cursor.word() : rest;
    if (word == "BINARY") cursor.fail("binary OFF is not supported; save it as text or as binary PLY");
    if (word.empty()) {
      cursor.require_line("the numbers of vertices and faces");
      word = cursor.word();
    }
  }
  if (!parse_integer(word, header.vertices)) {
    cursor.fail("expected the number of vertices, found " + quote(word));
  }
  header.faces = cursor.integer();
  if (cursor.at_line_end()) shape.warnings.emplace_back("the number of edges is missing");
  // Even "0 0 0" and "0" take that many bytes, the last line without its end.
  const auto left = static_cast<std::int64_t>(cursor.bytes_left());
  const bool fits = header.vertices >= 0 && header.faces >= 0 && header.vertices <= left &&
                    header.faces <= left && header.vertices * 6 + header.faces * 2 <= left + 1;
  if (!fits) {
    cursor.fail("the header promises " + std::to_string(header.vertices) + " vertices and " +
                std::to_string(header.faces) + " faces, which the " + std::to_string(left) +
                " bytes after it cannot hold; the file is cut off or its header wrong");
  }
  return header;
}

void read_vertices(TextCursor& cursor, const Header& header, PolygonMesh& mesh) {
  mesh.vertices.reserve(static_cast<std::size_t>(header.vertices));
  const bool keep_normals = header.normals && header.faces == 0;
  for (std::int64_t i = 0; i < header.vertices; ++i) {
    cursor.require_line("a vertex");
    Vec3& vertex = mesh.vertices.emplace_back();
    for (int axis = 0; axis < 3; ++axis) vertex[axis] = cursor.number();
    if (header.homogeneous) {
      vertex /= cursor.number();
      if (!vertex.allFinite()) cursor.fail("the fourth coordinate of a vertex must not be 0");
    }
    if (keep_normals) {
      Vec3& normal = mesh.point_normals.emplace_back();
      for (int axis = 0; axis < 3; ++axis) normal[axis] = cursor.number();
      normal.stableNormalize();
    }
  }
}

void read_faces(TextCursor& cursor, const Header& header, PolygonMesh& mesh) {
  mesh.face_begins.reserve(static_cast<std::size_t>(header.faces) + 1);
  mesh.face_corners.reserve(static_cast<std::size_t>(header.faces) * 3);
  for (std::int64_t f = 0; f < header.faces; ++f) {
    cursor.require_line("a face");
    const std::int64_t corners = cursor.integer();
    if (corners < 0) cursor.fail("a face cannot have " + std::to_string(corners) + " corners");
    for (std::int64_t c = 0; c < corners; ++c) {
      const std::int64_t index = cursor.integer();
      if (index < 0 || index >= header.vertices) {
        cursor.fail("the face refers to vertex " + std::to_string(index) + ", but they count from 0 to " +
                    std::to_string(header.vertices - 1));
      }
      mesh.face_corners.push_back(static_cast<std::uint32_t>(index));
    }
    end_face(mesh);
  }
}

}  // namespace

void read_off(const ShapeBytes& file, ShapeFile& shape) {
  TextCursor cursor(file.bytes, file.path);
  const Header header = read_header(cursor, shape);
  read_vertices(cursor, header, shape.mesh);
  read_faces(cursor, header, shape.mesh);
  if (cursor.next_line()) {
    shape.warnings.push_back("what follows the last face is not read, from line " +
                             std::to_string(cursor.line()));
  }
}

}  // namespace archetype
