// XYZ and PTS: a point a line, its coordinates first. PTS begins with the number of points, XYZ may; a file
// may hold several such blocks. Six columns are taken as point and normal if they look it; all other columns
// (intensity, colour) are passed over.
#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/io/readers.h"
#include "core/io/text_cursor.h"

namespace archetype {
namespace {

constexpr double normal_tolerance = 0.05;  // of its length, for files with few decimals

// A line of one whole number: how many points follow.
std::size_t read_count(std::string_view word, const TextCursor& cursor) {
  std::int64_t count = 0;
  if (!parse_integer(word, count) || count < 0) {
    cursor.fail("expected x y z or the number of points, found " + quote(word));
  }
  // Even "0 0 0" takes six bytes, the last line without its end.
  if (static_cast<std::uint64_t>(count) > (cursor.bytes_left() + 1) / 6) {
    cursor.fail("promises " + std::to_string(count) + " points, which the " +
                std::to_string(cursor.bytes_left()) +
                " bytes after it cannot hold; the file is cut off or the number wrong");
  }
  return static_cast<std::size_t>(count);
}

bool looks_like_normal(const Vec3& v) {
  const double length = v.stableNorm();
  return length == 0 || std::abs(length - 1) < normal_tolerance;
}

}  // namespace

void read_points(const ShapeBytes& file, ShapeFile& shape) {
  TextCursor cursor(file.bytes, file.path);
  PolygonMesh& mesh = shape.mesh;
  bool normals = true;  // until a line speaks against it
  bool counted = false;
  std::size_t promised = 0;
  while (cursor.next_line()) {
    const std::string_view first = cursor.word();
    if (cursor.at_line_end() && (mesh.vertices.empty() || counted) && mesh.vertices.size() >= promised) {
      promised = mesh.vertices.size() + read_count(first, cursor);
      counted = true;
      continue;
    }
    Vec3& point = mesh.vertices.emplace_back();
    if (!parse_number(first, point.x())) cursor.fail("expected a finite number, found " + quote(first));
    point.y() = cursor.number();
    point.z() = cursor.number();
    if (!normals) continue;
    Vec3 normal;
    int columns = 0;
    while (columns < 3 && parse_number(cursor.word(), normal[columns])) ++columns;
    normals = columns == 3 && cursor.at_line_end() && looks_like_normal(normal);
    if (normals) mesh.point_normals.push_back(normal.stableNormalized());
  }
  if (mesh.vertices.size() < promised) {
    cursor.fail("the file ends after " + std::to_string(mesh.vertices.size()) + " of " +
                std::to_string(promised) + " points; it is cut off");
  }
  if (counted && mesh.vertices.size() > promised) {
    shape.warnings.push_back("the file holds more points than the " + std::to_string(promised) +
                             " it promises");
  }
  const bool all_zero = std::ranges::all_of(mesh.point_normals, [](const Vec3& n) { return n.isZero(); });
  if (!normals || all_zero) mesh.point_normals.clear();
}

}  // namespace archetype
