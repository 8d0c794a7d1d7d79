// JSON from files of unknown origin.
#include "core/io/json_input.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/error.h"

namespace archetype {
namespace {

std::string place_of(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, byte);
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t line_begin = before.rfind('\n') + 1;  // npos + 1 is 0
  return "line " + std::to_string(line) + ", column " + std::to_string(before.size() - line_begin + 1);
}

// Looked at before parsing, so that a hostile file never becomes a deep tree.
void check_depth(std::string_view text, const std::filesystem::path& file, int max_depth) {
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\') ++i;
      in_string = c != '"';
    } else if (c == '"') {
      in_string = true;
    } else if (c == '[' || c == '{') {
      if (++depth > max_depth) {
        throw InputError(file, place_of(text, i),
                         "nested more than " + std::to_string(max_depth) + " levels deep");
      }
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
}

}  // namespace

nlohmann::json parse_json(std::string_view text, const std::filesystem::path& file, int max_depth) {
  check_depth(text, file, max_depth);
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    // The library's message repeats the position before a colon and its own names in brackets.
    std::string problem = error.what();
    const std::size_t colon = problem.find(": ");
    if (colon != problem.npos) problem.erase(0, colon + 2);
    throw InputError(file, place_of(text, error.byte > 0 ? error.byte - 1 : 0), "not valid JSON: " + problem);
  } catch (const nlohmann::json::exception& error) {
    throw InputError(file, "", std::string("not valid JSON: ") + error.what());
  }
}

}  // namespace archetype
