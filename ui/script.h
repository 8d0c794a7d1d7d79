// Scripts: one command a line, with its arguments; "#" begins a comment, quotes keep blanks together.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace archetype {

struct Studio;

struct ScriptLine {
  int number = 0;                  // in the file, from 1
  std::vector<std::string> words;  // the command's name first
};

// Throws InputError (file and line) for a quote that is not closed.
std::vector<ScriptLine> parse_script(std::string_view text, const std::filesystem::path& name);

// Every command has to be there before the first one is run. Throws InputError with the line.
void check_script(const Studio& studio, const std::vector<ScriptLine>& lines,
                  const std::filesystem::path& name);

struct Script {
  std::filesystem::path name;
  std::vector<ScriptLine> lines;
  std::size_t next = 0;

  bool over() const { return next >= lines.size(); }
};

// Once a frame: runs the next command if it need not wait for what is under way. Throws InputError with the
// line if it fails.
void advance(Script& script, Studio& studio);

}  // namespace archetype
