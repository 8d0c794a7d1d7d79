// Stanford PLY: ASCII and binary of either byte order, properties in any order. Elements and properties that
// are not ours are passed over. Triangle strips (element tristrips) become their triangles; faces come before
// strips.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "core/base/error.h"
#include "core/io/ply_header.h"
#include "core/io/text_cursor.h"

namespace archetype {
namespace {

// The two sources of values have the same functions, so that one loop reads both.
class AsciiBody {
 public:
  AsciiBody(const ShapeBytes& file, const PlyHeader& header)
      : cursor_(file.bytes.substr(header.body_begin), file.path, {.comments = false}, header.body_line) {}

  void begin_record() {
    note_rest_of_line();
    begun_ = true;
    cursor_.require_line("another record");
  }
  double next(PlyType type) {
    return type == PlyType::float32 || type == PlyType::float64 ? cursor_.number()
                                                                : static_cast<double>(cursor_.integer());
  }
  void skip(PlyType) {
    if (cursor_.word().empty()) cursor_.fail("the line ends where a value was expected");
  }
  // Needs all records to have been read.
  void add_warnings(std::vector<std::string>& warnings) {
    note_rest_of_line();
    if (long_lines_ > 0) {
      warnings.push_back("lines with more values than the header describes: " + std::to_string(long_lines_));
    }
    if (cursor_.next_line()) warnings.emplace_back("what follows the last record is not read");
  }
  [[noreturn]] void fail(const std::string& problem) const { cursor_.fail(problem); }

 private:
  void note_rest_of_line() {
    if (begun_ && !cursor_.at_line_end()) ++long_lines_;
  }

  TextCursor cursor_;
  bool begun_ = false;
  std::size_t long_lines_ = 0;
};

class BinaryBody {
 public:
  BinaryBody(const ShapeBytes& file, const PlyHeader& header)
      : file_(file),
        at_(header.body_begin),
        swap_((header.encoding == PlyEncoding::little_endian) !=
              (std::endian::native == std::endian::little)) {}

  void begin_record() {}
  double next(PlyType type) {
    switch (type) {
      case PlyType::int8:
        return take<std::int8_t>();
      case PlyType::uint8:
        return take<std::uint8_t>();
      case PlyType::int16:
        return take<std::int16_t>();
      case PlyType::uint16:
        return take<std::uint16_t>();
      case PlyType::int32:
        return take<std::int32_t>();
      case PlyType::uint32:
        return take<std::uint32_t>();
      case PlyType::float32:
        return take<float>();
      case PlyType::float64:
        break;
    }
    return take<double>();
  }
  void skip(PlyType type) { advance(byte_size(type)); }
  void add_warnings(std::vector<std::string>& warnings) const {
    if (at_ < file_.bytes.size()) warnings.emplace_back("what follows the last record is not read");
  }
  [[noreturn]] void fail(const std::string& problem) const {
    throw InputError(file_.path, "byte " + std::to_string(at_), problem);
  }

 private:
  const char* advance(std::size_t bytes) {
    if (bytes > file_.bytes.size() - at_) fail("the file ends within a record; it is cut off");
    const char* begin = file_.bytes.data() + at_;
    at_ += bytes;
    return begin;
  }
  template <typename T>
  double take() {
    std::array<char, sizeof(T)> bytes;
    std::memcpy(bytes.data(), advance(sizeof(T)), sizeof(T));
    if (swap_) std::reverse(bytes.begin(), bytes.end());
    return static_cast<double>(std::bit_cast<T>(bytes));
  }

  const ShapeBytes& file_;
  std::size_t at_;
  bool swap_;
};

std::string short_text(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.10g", value);
  return text.data();
}

// The triangles of strips; -1 starts a new strip, every second triangle is turned.
void append_strip(const std::vector<std::int64_t>& strip, PolygonMesh& mesh) {
  std::size_t begin = 0;
  for (std::size_t i = 0; i < strip.size(); ++i) {
    if (strip[i] < 0) begin = i + 1;
    if (i < begin + 2) continue;
    const bool odd = (i - begin) % 2 == 1;
    for (const std::size_t corner : {odd ? i - 1 : i - 2, odd ? i - 2 : i - 1, i}) {
      mesh.face_corners.push_back(static_cast<std::uint32_t>(strip[corner]));
    }
    end_face(mesh);
  }
}

template <typename Body>
class PlyReader {
 public:
  PlyReader(Body body, std::size_t vertex_count, PolygonMesh& mesh)
      : body_(std::move(body)), vertex_count_(vertex_count), mesh_(mesh) {}

  void read(const PlyElement& element) {
    if (element.properties.empty()) return;
    const bool vertices = element.name == "vertex";
    if (vertices) mesh_.vertices.reserve(element.count);
    if (element.name == "face") mesh_.face_begins.reserve(element.count + 1);
    const bool normals =
        vertices && element.has(PlyRole::nx) && element.has(PlyRole::ny) && element.has(PlyRole::nz);
    for (std::size_t i = 0; i < element.count; ++i) {
      body_.begin_record();
      Vec3 position = Vec3::Zero();
      Vec3 normal = Vec3::Zero();
      for (const PlyProperty& property : element.properties) read(property, position, normal);
      if (vertices) mesh_.vertices.push_back(position);
      if (normals)
        mesh_.point_normals.push_back(normal.allFinite() ? normal.stableNormalized() : Vec3::Zero());
    }
  }
  void add_warnings(std::vector<std::string>& warnings) { body_.add_warnings(warnings); }

 private:
  void read(const PlyProperty& property, Vec3& position, Vec3& normal) {
    switch (property.role) {
      case PlyRole::x:
        position.x() = coordinate(property.type);
        break;
      case PlyRole::y:
        position.y() = coordinate(property.type);
        break;
      case PlyRole::z:
        position.z() = coordinate(property.type);
        break;
      case PlyRole::nx:
        normal.x() = body_.next(property.type);
        break;
      case PlyRole::ny:
        normal.y() = body_.next(property.type);
        break;
      case PlyRole::nz:
        normal.z() = body_.next(property.type);
        break;
      case PlyRole::none:
        skip(property);
        break;
      case PlyRole::face_corners:
        read_face(property);
        break;
      case PlyRole::strip_corners:
        read_strip(property);
        break;
    }
  }

  double coordinate(PlyType type) {
    const double value = body_.next(type);
    if (!std::isfinite(value)) body_.fail("a coordinate is not a finite number");
    return value;
  }

  void skip(const PlyProperty& property) {
    const std::size_t count = property.list_count ? list_length(property) : 1;
    for (std::size_t i = 0; i < count; ++i) body_.skip(property.type);
  }

  std::size_t list_length(const PlyProperty& property) {
    const double length = body_.next(*property.list_count);
    if (!(length >= 0 && length <= 0xFFFFFFFFp0) || length != std::floor(length)) {
      body_.fail("a list cannot have " + short_text(length) + " entries");
    }
    return static_cast<std::size_t>(length);
  }

  std::int64_t vertex_index(PlyType type, double least) {
    const double index = body_.next(type);
    if (!(index >= least && index < static_cast<double>(vertex_count_)) || index != std::floor(index)) {
      body_.fail("a face refers to vertex " + short_text(index) + ", but they count from 0 to " +
                 std::to_string(static_cast<std::int64_t>(vertex_count_) - 1));
    }
    return static_cast<std::int64_t>(index);
  }

  void read_face(const PlyProperty& property) {
    const std::size_t corners = list_length(property);
    for (std::size_t i = 0; i < corners; ++i) {
      mesh_.face_corners.push_back(static_cast<std::uint32_t>(vertex_index(property.type, 0)));
    }
    end_face(mesh_);
  }

  void read_strip(const PlyProperty& property) {
    strip_.clear();
    const std::size_t corners = list_length(property);
    for (std::size_t i = 0; i < corners; ++i) strip_.push_back(vertex_index(property.type, -1));
    append_strip(strip_, mesh_);
  }

  Body body_;
  std::size_t vertex_count_;
  PolygonMesh& mesh_;
  std::vector<std::int64_t> strip_;
};

template <typename Body>
void read_body(const ShapeBytes& file, const PlyHeader& header, ShapeFile& shape) {
  PlyReader<Body> reader(Body(file, header), header.count("vertex"), shape.mesh);
  for (const PlyElement& element : header.elements) reader.read(element);
  reader.add_warnings(shape.warnings);
}

}  // namespace

void read_ply(const ShapeBytes& file, ShapeFile& shape) {
  const PlyHeader header = parse_ply_header(file);
  if (header.encoding == PlyEncoding::ascii) {
    read_body<AsciiBody>(file, header, shape);
  } else {
    read_body<BinaryBody>(file, header, shape);
  }
}

}  // namespace archetype
