// The rules that keep the code as it is laid out, as functions over file contents, so that they are tested
// themselves.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace archetype {

inline constexpr std::size_t most_lines = 450;  // of a source file

// A line per include that points against core <- render <- ui <- app, or to a library that the folder must
// not know: OpenGL and the window's libraries in core and app/batch, OpenGL outside render, GLFW and Dear
// ImGui in render. `file` is the path from the repository root; it decides what is allowed.
std::vector<std::string> forbidden_includes(const std::filesystem::path& file, const std::string& content);

// The names that a CMakeLists.txt holds as separate words, comments left out.
std::vector<std::string> listed_names(const std::string& cmake_lists);

std::size_t line_count(const std::string& content);

}  // namespace archetype
