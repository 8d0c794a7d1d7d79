// What files may include, and how they are listed.
#include "tests/structure/source_rules.h"

#include <algorithm>
#include <regex>
#include <sstream>
#include <string_view>

namespace archetype {

namespace {

bool starts_with(std::string_view text, std::string_view beginning) {
  return text.substr(0, beginning.size()) == beginning;
}

bool starts_with_any(std::string_view text, const std::vector<std::string_view>& beginnings) {
  return std::any_of(beginnings.begin(), beginnings.end(),
                     [&](auto beginning) { return starts_with(text, beginning); });
}

// What no file below `folder` may include.
struct Rule {
  std::string_view folder;
  std::vector<std::string_view> never;
};

const std::vector<Rule>& rules() {
  static const std::vector<Rule> all = {
      {"core/",
       {"render/", "ui/", "app/", "tests/", "GL/", "GLES", "EGL/", "epoxy/", "GLFW/", "glm/", "imgui",
        "backends/imgui"}},
      {"render/", {"ui/", "app/", "tests/", "GLFW/", "imgui", "backends/imgui"}},
      {"ui/", {"app/", "tests/", "GL/", "GLES", "EGL/", "epoxy/"}},
      {"app/", {"tests/"}},
      {"app/batch/",
       {"render/", "ui/", "GL/", "GLES", "EGL/", "epoxy/", "GLFW/", "glm/", "imgui", "backends/imgui"}},
  };
  return all;
}

}  // namespace

std::vector<std::string> forbidden_includes(const std::filesystem::path& file, const std::string& content) {
  static const std::regex include(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"])");
  std::vector<std::string> found;
  std::istringstream lines(content);
  std::size_t number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    std::smatch match;
    if (!std::regex_search(line, match, include)) continue;
    const std::string target = match[1];
    for (const Rule& rule : rules()) {
      if (starts_with(file.generic_string(), rule.folder) && starts_with_any(target, rule.never)) {
        found.push_back(file.generic_string() + ", line " + std::to_string(number) + ": " +
                        std::string(rule.folder) + " must not include " + target);
      }
    }
  }
  return found;
}

std::vector<std::string> listed_names(const std::string& cmake_lists) {
  std::vector<std::string> names;
  std::istringstream lines(cmake_lists);
  for (std::string line; std::getline(lines, line);) {
    line.resize(std::min(line.find('#'), line.size()));
    for (char& c : line) {
      if (c == '(' || c == ')') c = ' ';
    }
    std::istringstream words(line);
    for (std::string word; words >> word;) names.push_back(word);
  }
  return names;
}

std::size_t line_count(const std::string& content) {
  return static_cast<std::size_t>(std::count(content.begin(), content.end(), '\n'));
}

}  // namespace archetype
