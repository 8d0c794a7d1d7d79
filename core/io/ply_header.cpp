// Parses and checks PLY headers. All that decides how much memory the body takes is settled here.
#include "core/io/ply_header.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/error.h"
#include "core/io/text_cursor.h"

namespace archetype {
namespace {

constexpr std::size_t most_elements = 100;
constexpr std::size_t most_properties = 1000;

PlyType parse_type(std::string_view word, const TextCursor& cursor) {
  constexpr std::array<std::pair<std::string_view, PlyType>, 16> types{{
      {"char", PlyType::int8},
      {"int8", PlyType::int8},
      {"uchar", PlyType::uint8},
      {"uint8", PlyType::uint8},
      {"short", PlyType::int16},
      {"int16", PlyType::int16},
      {"ushort", PlyType::uint16},
      {"uint16", PlyType::uint16},
      {"int", PlyType::int32},
      {"int32", PlyType::int32},
      {"uint", PlyType::uint32},
      {"uint32", PlyType::uint32},
      {"float", PlyType::float32},
      {"float32", PlyType::float32},
      {"double", PlyType::float64},
      {"float64", PlyType::float64},
  }};
  for (const auto& [name, type] : types) {
    if (name == word) return type;
  }
  cursor.fail("expected a type such as float or uchar, found " + quote(word));
}

PlyRole role_of(const PlyElement& element, std::string_view name, bool list) {
  if (list) {
    if (name != "vertex_indices" && name != "vertex_index") return PlyRole::none;
    if (element.name == "face") return PlyRole::face_corners;
    return element.name == "tristrips" ? PlyRole::strip_corners : PlyRole::none;
  }
  if (element.name != "vertex") return PlyRole::none;
  constexpr std::array<std::pair<std::string_view, PlyRole>, 6> roles{{{"x", PlyRole::x},
                                                                       {"y", PlyRole::y},
                                                                       {"z", PlyRole::z},
                                                                       {"nx", PlyRole::nx},
                                                                       {"ny", PlyRole::ny},
                                                                       {"nz", PlyRole::nz}}};
  for (const auto& [key, role] : roles) {
    if (key == name) return role;
  }
  return PlyRole::none;
}

PlyEncoding parse_encoding(TextCursor& cursor) {
  const std::string_view word = cursor.word();
  const std::string_view version = cursor.word();
  if (version != "1.0") cursor.fail("expected version 1.0 of the format, found " + quote(version));
  if (word == "ascii") return PlyEncoding::ascii;
  if (word == "binary_little_endian") return PlyEncoding::little_endian;
  if (word == "binary_big_endian") return PlyEncoding::big_endian;
  cursor.fail("expected ascii, binary_little_endian or binary_big_endian, found " + quote(word));
}

void parse_element(TextCursor& cursor, PlyHeader& header) {
  PlyElement element;
  element.name = cursor.word();
  const std::int64_t count = cursor.integer();
  if (count < 0) cursor.fail("an element cannot have " + std::to_string(count) + " records");
  if (header.elements.size() == most_elements) cursor.fail("more than 100 elements");
  element.count = static_cast<std::size_t>(count);
  header.elements.push_back(std::move(element));
}

void parse_property(TextCursor& cursor, PlyHeader& header) {
  if (header.elements.empty()) cursor.fail("a property stands before the first element");
  PlyElement& element = header.elements.back();
  if (element.properties.size() == most_properties) cursor.fail("more than 1000 properties in an element");
  PlyProperty property;
  std::string_view word = cursor.word();
  const bool list = word == "list";
  if (list) {
    property.list_count = parse_type(cursor.word(), cursor);
    word = cursor.word();
  }
  property.type = parse_type(word, cursor);
  const std::string_view name = cursor.word();
  if (name.empty()) cursor.fail("the property has no name");
  property.role = role_of(element, name, list);
  if (property.role != PlyRole::none && element.has(property.role)) {
    cursor.fail("the property " + quote(name) + " stands twice in the element");
  }
  element.properties.push_back(property);
}

void check(const PlyHeader& header, const ShapeBytes& file) {
  const auto vertices = std::ranges::find(header.elements, "vertex", &PlyElement::name);
  if (vertices == header.elements.end()) {
    throw InputError(file.path, "header", "expected \"element vertex\": there is none");
  }
  for (const PlyRole role : {PlyRole::x, PlyRole::y, PlyRole::z}) {
    if (!vertices->has(role)) throw InputError(file.path, "header", "the vertices lack a property x, y or z");
  }
  std::size_t left = file.bytes.size() - header.body_begin;
  // An ASCII body may lack its last line's end.
  if (header.encoding == PlyEncoding::ascii) ++left;
  for (const PlyElement& element : header.elements) {
    if (std::ranges::count(header.elements, element.name, &PlyElement::name) > 1) {
      throw InputError(file.path, "header", "the element " + quote(element.name) + " stands there twice");
    }
    if (element.name == "face" && element.count > 0 && !element.has(PlyRole::face_corners)) {
      throw InputError(file.path, "header", "the faces lack a list property vertex_indices");
    }
    const std::size_t least = element.least_bytes(header.encoding == PlyEncoding::ascii);
    if (least > 0 && element.count > left / least) {
      throw InputError(file.path, "header",
                       "promises " + std::to_string(element.count) + " records of " + quote(element.name) +
                           ", which the bytes after it cannot hold; the file is cut off or its header wrong");
    }
    left -= element.count * least;
  }
}

}  // namespace

std::size_t byte_size(PlyType type) {
  constexpr std::array<std::size_t, 8> sizes{1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

bool PlyElement::has(PlyRole role) const {
  return std::ranges::find(properties, role, &PlyProperty::role) != properties.end();
}

std::size_t PlyElement::least_bytes(bool ascii) const {
  if (ascii) return 2 * properties.size();  // a digit, and a blank or line end
  std::size_t bytes = 0;
  for (const PlyProperty& property : properties)
    bytes += byte_size(property.list_count.value_or(property.type));
  return bytes;
}

std::size_t PlyHeader::count(std::string_view element) const {
  const auto found = std::ranges::find(elements, element, &PlyElement::name);
  return found == elements.end() ? 0 : found->count;
}

PlyHeader parse_ply_header(const ShapeBytes& file) {
  TextCursor cursor(file.bytes, file.path, {.comments = false});
  if (!cursor.next_line() || cursor.rest_of_line() != "ply")
    cursor.fail("expected \"ply\" on the first line");
  PlyHeader header;
  bool has_format = false;
  for (;;) {
    cursor.require_line("end_header");
    const std::string_view key = cursor.word();
    if (key == "end_header") break;
    if (key == "format") {
      header.encoding = parse_encoding(cursor);
      has_format = true;
    } else if (key == "element") {
      parse_element(cursor, header);
    } else if (key == "property") {
      parse_property(cursor, header);
    } else if (key != "comment" && key != "obj_info") {
      cursor.fail("expected element, property, comment or end_header, found " + quote(key));
    }
  }
  cursor.skip_bytes_after_line(0);
  if (!has_format) throw InputError(file.path, "header", "expected a line \"format ...\"");
  header.body_begin = file.bytes.size() - cursor.bytes_left();
  header.body_line = cursor.line();
  check(header, file);
  return header;
}

}  // namespace archetype
