// Files of ground-truth and result labels, one integer per face (or per point of a point set).
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace archetype {

// The label of each element; -1 where the file gives none.
// `.seg`: one integer per line. `_labels.txt`: a line with a name, a line with 1-based face numbers,
// repeated; names are numbered in order of appearance. Throws InputError if the count or a number does not
// fit `element_count`.
std::vector<int> read_labels(const std::filesystem::path& path, std::size_t element_count);
// The same; `names` receives the names by label, none for a `.seg`. Files of one collection may number the
// same names differently.
std::vector<int> read_labels(const std::filesystem::path& path, std::size_t element_count,
                             std::vector<std::string>& names);

// The label file of a shape in a folder: SHAPE.seg or SHAPE_labels.txt, or nothing.
std::optional<std::filesystem::path> find_labels(const std::filesystem::path& folder,
                                                 const std::string& shape_name);

// The names in FOLDER/names.txt by number: "0 seat" and so on, a line each. Empty where there is no such
// file, or it is another one.
std::vector<std::string> read_numbered_names(const std::filesystem::path& folder);

void write_labels(const std::filesystem::path& path, std::span<const int> labels);

// Landmarks: one "x y z" a line, "-1" alone for a landmark that the shape lacks.
struct Landmark {
  bool present = false;
  std::array<double, 3> position{};
};
// The landmark file of a shape in a folder, SHAPE.vts, or nothing.
std::optional<std::filesystem::path> find_landmarks(const std::filesystem::path& folder,
                                                    const std::string& shape_name);
std::vector<Landmark> read_landmarks(const std::filesystem::path& path);

}  // namespace archetype
