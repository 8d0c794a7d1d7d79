// Wavefront OBJ: the polygons (`f`) of all objects and groups in file order. Everything else (lines, points,
// curves, texture coordinates, materials) is passed over; material libraries and other files it names are
// never opened.
#include "core/base/error.h"
#include "core/io/readers.h"
#include "core/io/text_cursor.h"

namespace archetype {
namespace {

// The largest index that a face uses, and where: its vertex may stand further down in the file.
struct LargestIndex {
  std::int64_t index = 0;
  std::size_t line = 0;
};

// One corner: `v`, `v/vt`, `v//vn` or `v/vt/vn`. Only v is looked at. Counts from 1, or back from -1.
std::int64_t vertex_index(std::string_view word, std::size_t vertex_count, const TextCursor& cursor) {
  std::int64_t index = 0;
  if (!parse_integer(word.substr(0, word.find('/')), index)) {
    cursor.fail("expected a corner such as 3 or 3/1/2, found " + quote(word));
  }
  if (index < 0) index += static_cast<std::int64_t>(vertex_count) + 1;
  if (index < 1) {
    cursor.fail("the corner " + quote(word) +
                " refers to no vertex: they count from 1, or from -1 backwards");
  }
  return index;
}

}  // namespace

void read_obj(const ShapeBytes& file, ShapeFile& shape) {
  TextCursor cursor(file.bytes, file.path, {.comments = true, .continuation = true});
  PolygonMesh& mesh = shape.mesh;
  LargestIndex largest;
  while (cursor.next_line()) {
    const std::string_view key = cursor.word();
    if (key == "v") {
      Vec3& vertex = mesh.vertices.emplace_back();
      for (int axis = 0; axis < 3; ++axis) vertex[axis] = cursor.number();
    } else if (key == "f" || key == "fo") {  // "fo": its name before version 3 of the format
      for (std::string_view word = cursor.word(); !word.empty(); word = cursor.word()) {
        const std::int64_t index = vertex_index(word, mesh.vertices.size(), cursor);
        if (index > largest.index) largest = {index, cursor.line()};
        mesh.face_corners.push_back(static_cast<std::uint32_t>(index - 1));
      }
      end_face(mesh);
    }
  }
  if (mesh.vertices.empty())
    throw InputError(file.path, "", "expected OBJ text, found no line that begins with v");
  if (largest.index > static_cast<std::int64_t>(mesh.vertices.size())) {
    throw InputError(file.path, "line " + std::to_string(largest.line),
                     "the face refers to vertex " + std::to_string(largest.index) +
                         ", but the file has only " + std::to_string(mesh.vertices.size()));
  }
}

}  // namespace archetype
