// Label and landmark files of the COSEG and Princeton collections.
#include "core/io/labels.h"

#include <algorithm>
#include <limits>
#include <map>

#include "core/base/error.h"
#include "core/io/export_files.h"
#include "core/io/file.h"
#include "core/io/text_cursor.h"

namespace archetype {
namespace {

constexpr std::string_view named_ending = "_labels.txt";

std::vector<int> read_numbered(TextCursor& cursor, std::size_t element_count) {
  std::vector<int> labels;
  while (cursor.next_line()) {
    if (labels.size() == element_count) {
      cursor.fail("expected one label for each of the " + std::to_string(element_count) +
                  " elements of the shape, found more");
    }
    const std::int64_t label = cursor.integer();
    if (label < -1 || label > std::numeric_limits<int>::max()) {
      cursor.fail("expected a label of 0 or more, or -1 for none, found " + std::to_string(label));
    }
    if (!cursor.at_line_end())
      cursor.fail("expected one label a line, found " + quote(cursor.rest_of_line()));
    labels.push_back(static_cast<int>(label));
  }
  if (labels.size() != element_count) {
    cursor.fail("expected one label for each of the " + std::to_string(element_count) +
                " elements of the shape, found " + std::to_string(labels.size()));
  }
  return labels;
}

// The faces on the rest of this line.
void read_faces(TextCursor& cursor, int label, std::vector<int>& labels) {
  while (!cursor.at_line_end()) {
    const std::int64_t face = cursor.integer();
    if (face < 1 || static_cast<std::uint64_t>(face) > labels.size()) {
      cursor.fail("expected face numbers from 1 to " + std::to_string(labels.size()) + ", found " +
                  std::to_string(face));
    }
    int& slot = labels[static_cast<std::size_t>(face - 1)];
    if (slot >= 0 && slot != label) cursor.fail("face " + std::to_string(face) + " has two labels");
    slot = label;
  }
}

// A name without faces is followed by an empty line or by the next name: a line that begins with a number is
// the list of the name before it, every other one is a name.
std::vector<int> read_named(TextCursor& cursor, std::size_t element_count, std::vector<std::string>& names) {
  std::vector<int> labels(element_count, -1);
  std::map<std::string, int> numbers;
  int label = -1;
  while (cursor.next_line()) {
    TextCursor line = cursor;
    std::int64_t number = 0;
    if (parse_integer(line.word(), number)) {
      if (label < 0) cursor.fail("expected the name of a label before the first face numbers");
      read_faces(cursor, label, labels);
    } else {
      const std::string name(cursor.rest_of_line());
      const auto [entry, is_new] = numbers.try_emplace(name, static_cast<int>(names.size()));
      if (is_new) names.push_back(name);
      label = entry->second;
    }
  }
  return labels;
}

// The file of that name if it is right in the folder: names of shapes are not trusted.
std::optional<std::filesystem::path> find_beside(const std::filesystem::path& folder,
                                                 const std::string& name) {
  std::error_code ignored;
  const std::filesystem::path path = folder / name;
  if (std::filesystem::path(name).filename() != name) return {};
  if (!std::filesystem::is_regular_file(path, ignored)) return {};
  return path;
}

// Under the shape's own name, or else the one that an export gives to a name that cannot be a file's.
std::optional<std::filesystem::path> find_of_shape(const std::filesystem::path& folder,
                                                   const std::string& shape_name,
                                                   std::initializer_list<std::string_view> endings) {
  for (const std::string& name : {shape_name, export_file_name(shape_name)})
    for (const std::string_view ending : endings)
      if (auto found = find_beside(folder, name + std::string(ending))) return found;
  return {};
}

}  // namespace

std::vector<int> read_labels(const std::filesystem::path& path, std::size_t element_count) {
  std::vector<std::string> names;
  return read_labels(path, element_count, names);
}

std::vector<int> read_labels(const std::filesystem::path& path, std::size_t element_count,
                             std::vector<std::string>& names) {
  names.clear();
  const std::string content = read_file(path);
  TextCursor cursor(content, path);
  return path.filename().string().ends_with(named_ending) ? read_named(cursor, element_count, names)
                                                          : read_numbered(cursor, element_count);
}

std::optional<std::filesystem::path> find_labels(const std::filesystem::path& folder,
                                                 const std::string& shape_name) {
  return find_of_shape(folder, shape_name, {".seg", named_ending});
}

std::vector<std::string> read_numbered_names(const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / "names.txt";
  std::vector<std::string> names;
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return names;
  const std::string content = read_file(path);
  for (std::size_t at = 0; at < content.size();) {
    const std::size_t end = std::min(content.find('\n', at), content.size());
    std::string line = content.substr(at, end - at);
    if (line.ends_with('\r')) line.pop_back();
    at = end + 1;
    const std::string number = std::to_string(names.size()) + ' ';
    if (!line.starts_with(number)) return {};
    names.push_back(line.substr(number.size()));
  }
  return names;
}

void write_labels(const std::filesystem::path& path, std::span<const int> labels) {
  std::string content;
  content.reserve(labels.size() * 3);
  for (const int label : labels) content += std::to_string(label) += '\n';
  replace_file(path, content);
}

std::optional<std::filesystem::path> find_landmarks(const std::filesystem::path& folder,
                                                    const std::string& shape_name) {
  return find_of_shape(folder, shape_name, {".vts"});
}

std::vector<Landmark> read_landmarks(const std::filesystem::path& path) {
  const std::string content = read_file(path);
  TextCursor cursor(content, path);
  std::vector<Landmark> landmarks;
  while (cursor.next_line()) {
    Landmark& landmark = landmarks.emplace_back();
    landmark.position[0] = cursor.number();
    if (cursor.at_line_end()) {
      if (landmark.position[0] != -1)
        cursor.fail("expected x y z, or -1 alone for a landmark that is not there");
      landmark.position = {};
      continue;
    }
    landmark.present = true;
    landmark.position[1] = cursor.number();
    landmark.position[2] = cursor.number();
    if (!cursor.at_line_end()) cursor.fail("expected x y z, found more: " + quote(cursor.rest_of_line()));
  }
  return landmarks;
}

}  // namespace archetype
