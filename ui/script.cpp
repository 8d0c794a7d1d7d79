#include "ui/script.h"

#include <span>

#include "core/base/error.h"
#include "ui/studio.h"

namespace archetype {
namespace {

std::string place(int line) {
  return "line " + std::to_string(line);
}

std::vector<std::string> split(std::string_view line, const std::filesystem::path& name, int number) {
  std::vector<std::string> words;
  std::size_t at = 0;
  for (;;) {
    at = line.find_first_not_of(" \t\r", at);
    if (at == std::string_view::npos || line[at] == '#') return words;
    if (line[at] == '"') {
      const std::size_t end = line.find('"', at + 1);
      if (end == std::string_view::npos) throw InputError(name, place(number), "a quote is not closed");
      words.emplace_back(line.substr(at + 1, end - at - 1));
      at = end + 1;
    } else {
      const std::size_t end = std::min(line.find_first_of(" \t\r", at), line.size());
      words.emplace_back(line.substr(at, end - at));
      at = end;
    }
  }
}

}  // namespace

std::vector<ScriptLine> parse_script(std::string_view text, const std::filesystem::path& name) {
  std::vector<ScriptLine> lines;
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    ScriptLine line{number, split(text.substr(0, end), name, number)};
    if (!line.words.empty()) lines.push_back(std::move(line));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

void check_script(const Studio& studio, const std::vector<ScriptLine>& lines,
                  const std::filesystem::path& name) {
  for (const ScriptLine& line : lines)
    if (!find_command(studio, line.words[0]))
      throw InputError(name, place(line.number),
                       "there is no command \"" + line.words[0] + "\"; F1 in the window lists them");
}

void advance(Script& script, Studio& studio) {
  if (script.over()) return;
  const ScriptLine& line = script.lines[script.next];
  const Command* command = find_command(studio, line.words[0]);
  if (command && !command->at_once && !settled(studio)) return;
  ++script.next;
  try {
    run_command_or_throw(studio, line.words[0], std::span(line.words).subspan(1));
  } catch (const std::exception& error) {
    throw InputError(script.name, place(line.number), error.what());
  }
}

}  // namespace archetype
