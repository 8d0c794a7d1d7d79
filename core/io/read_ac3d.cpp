// AC3D (.ac), the format of FlightGear's models: a tree of objects, each with a transform, vertices and
// surfaces. The polygons of all objects in file order are the faces. Surfaces that are lines are no faces:
// they have no area, and a label for them would mean nothing; they are passed over and said.
#include <Eigen/Geometry>
#include <charconv>

#include "core/base/error.h"
#include "core/io/readers.h"
#include "core/io/text_cursor.h"

namespace archetype {
namespace {

// An object whose end (`kids` and as many objects) has not been reached.
struct OpenObject {
  Eigen::Affine3d parent;
  Eigen::Affine3d local = Eigen::Affine3d::Identity();
  std::size_t first_vertex = 0;
  std::int64_t kids_left = -1;  // -1: its own part has not ended yet
};

class Ac3dReader {
 public:
  Ac3dReader(const ShapeBytes& file, ShapeFile& shape)
      : cursor_(file.bytes, file.path, {.comments = false}), shape_(shape), mesh_(shape.mesh) {}

  void read() {
    if (!cursor_.next_line() || !cursor_.word().starts_with("AC3D"))
      cursor_.fail("expected AC3D on the first line");
    while (cursor_.next_line()) read_line(cursor_.word());
    if (!open_.empty() && open_.back().kids_left < 0)
      cursor_.fail("the file ends within an object; it is cut off");
    // Common in files that were edited by hand, and every object that is there is whole.
    if (!open_.empty()) shape_.warnings.emplace_back("fewer objects than promised; the file may be cut off");
    if (lines_ > 0)
      shape_.warnings.push_back("surfaces that are lines and no faces: " + std::to_string(lines_));
  }

 private:
  void read_line(std::string_view key) {
    if (key == "OBJECT") {
      begin_object();
    } else if (key == "loc") {
      for (int axis = 0; axis < 3; ++axis) object().local.translation()[axis] = cursor_.number();
    } else if (key == "rot") {
      // Row vectors, as FlightGear's loaders have it: p' = p R. So the rows of the file are our columns.
      for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) object().local.linear()(row, column) = cursor_.number();
      }
    } else if (key == "data") {
      cursor_.skip_bytes_after_line(count());
    } else if (key == "numvert") {
      read_vertices(count());
    } else if (key == "numsurf") {
      const std::size_t surfaces = count();
      for (std::size_t i = 0; i < surfaces; ++i) read_surface();
    } else if (key == "kids") {
      end_object(count());
    } else if (double number = 0; parse_number(key, number)) {
      cursor_.fail("expected a key such as OBJECT or kids, found " + quote(key) +
                   "; a count before is too small");
    }
  }

  std::size_t count() {
    object();
    const std::int64_t number = cursor_.integer();
    if (number < 0) cursor_.fail("expected a number of 0 or more, found " + std::to_string(number));
    return static_cast<std::size_t>(number);
  }

  OpenObject& object() {
    if (open_.empty() || open_.back().kids_left >= 0) cursor_.fail("expected OBJECT first");
    return open_.back();
  }

  void begin_object() {
    if (!open_.empty() && open_.back().kids_left < 0) cursor_.fail("expected kids before the next OBJECT");
    OpenObject next;
    next.parent = open_.empty() ? Eigen::Affine3d::Identity() : open_.back().parent * open_.back().local;
    next.first_vertex = mesh_.vertices.size();
    open_.push_back(next);
  }

  // Transforms the object's vertices, and ends the objects above whose last kid this was.
  void end_object(std::size_t kids) {
    OpenObject& ended = object();
    const Eigen::Affine3d transform = ended.parent * ended.local;
    for (std::size_t i = ended.first_vertex; i < mesh_.vertices.size(); ++i) {
      mesh_.vertices[i] = transform * mesh_.vertices[i];
      if (!mesh_.vertices[i].allFinite())
        cursor_.fail("the transform of the object leads to a number that is not finite");
    }
    ended.kids_left = static_cast<std::int64_t>(kids);
    while (!open_.empty() && open_.back().kids_left == 0) {
      open_.pop_back();
      if (!open_.empty()) --open_.back().kids_left;
    }
  }

  void read_vertices(std::size_t number) {
    for (std::size_t i = 0; i < number; ++i) {
      cursor_.require_line("a vertex");
      Vec3& vertex = mesh_.vertices.emplace_back();
      for (int axis = 0; axis < 3; ++axis) vertex[axis] = cursor_.number();
    }
  }

  void read_surface() {
    unsigned kind = 0;
    for (;;) {
      cursor_.require_line("a surface");
      const std::string_view key = cursor_.word();
      if (key == "SURF") kind = parse_flags(cursor_.word()) & 0xFU;
      if (key == "refs") break;
      if (key != "SURF" && key != "mat") cursor_.fail("expected SURF, mat or refs, found " + quote(key));
    }
    const std::size_t corners = count();
    const std::size_t first = object().first_vertex;
    const std::size_t vertices = mesh_.vertices.size() - first;
    const bool polygon = kind == 0;
    for (std::size_t i = 0; i < corners; ++i) {
      cursor_.require_line("a corner");
      const std::int64_t index = cursor_.integer();
      if (index < 0 || static_cast<std::size_t>(index) >= vertices) {
        cursor_.fail("the surface refers to vertex " + std::to_string(index) + ", but the object has only " +
                     std::to_string(vertices));
      }
      if (polygon)
        mesh_.face_corners.push_back(static_cast<std::uint32_t>(first + static_cast<std::size_t>(index)));
    }
    if (polygon) {
      end_face(mesh_);
    } else {
      ++lines_;
    }
  }

  unsigned parse_flags(std::string_view word) const {
    std::string_view digits = word;
    const bool hexadecimal = digits.starts_with("0x") || digits.starts_with("0X");
    if (hexadecimal) digits.remove_prefix(2);
    unsigned flags = 0;
    const char* end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, flags, hexadecimal ? 16 : 10);
    if (error != std::errc() || stop != end)
      cursor_.fail("expected flags such as 0x10, found " + quote(word));
    if ((flags & 0xFU) > 2) cursor_.fail("surfaces of the kind " + quote(word) + " are not supported");
    return flags;
  }

  TextCursor cursor_;
  ShapeFile& shape_;
  PolygonMesh& mesh_;
  std::vector<OpenObject> open_;
  std::size_t lines_ = 0;
};

}  // namespace

void read_ac3d(const ShapeBytes& file, ShapeFile& shape) {
  Ac3dReader(file, shape).read();
}

}  // namespace archetype
