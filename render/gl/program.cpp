// Reading, compiling and linking of shaders, with errors that name the file and the line.
#include "render/gl/program.h"

#include <epoxy/gl.h>

#include <fstream>
#include <glm/gtc/type_ptr.hpp>
#include <regex>
#include <sstream>
#include <vector>

#include "core/base/error.h"

namespace archetype::gl {
namespace {

// The text that the driver gets. It calls files by their number in `files`.
struct Source {
  std::string text;
  std::vector<std::filesystem::path> files;
};

std::string read_text(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  if (!stream || !text)
    throw FileError(file, "cannot read this shader; is the program installed completely?");
  return text.str();
}

Source read_source(const std::filesystem::path& file) {
  static const std::regex include_line("\\s*#include\\s+\"([^\"]+)\"\\s*");
  Source source{{}, {file}};
  std::istringstream lines(read_text(file));
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::smatch match;
    if (!std::regex_match(line, match, include_line)) {
      source.text += line + "\n";
      continue;
    }
    const std::filesystem::path included = file.parent_path() / match[1].str();
    source.text += "#line 1 " + std::to_string(source.files.size()) + "\n" + read_text(included);
    source.text += "\n#line " + std::to_string(number + 1) + " 0\n";
    source.files.push_back(included);
  }
  return source;
}

// Mesa writes "0:12(5): error: …", NVIDIA "0(12) : error …", AMD and Apple "ERROR: 0:12: …": always the
// number of the file, then that of the line.
[[noreturn]] void throw_compile_error(const Source& source, const std::string& log) {
  static const std::regex place_of_error("(\\d+)[:(](\\d+)");
  const std::string first_line = log.substr(0, log.find('\n'));
  std::smatch match;
  if (std::regex_search(first_line, match, place_of_error)) {
    const std::size_t file = std::stoul(match[1].str());
    if (file < source.files.size())
      throw InputError(source.files[file], "line " + match[2].str(), "does not compile: " + first_line);
  }
  throw InputError(source.files[0], "", "does not compile: " + first_line);
}

ShaderHandle compile(GLenum stage, const Source& source) {
  ShaderHandle shader(glCreateShader(stage));
  const char* text = source.text.c_str();
  glShaderSource(shader.name(), 1, &text, nullptr);
  glCompileShader(shader.name());
  GLint good = 0;
  glGetShaderiv(shader.name(), GL_COMPILE_STATUS, &good);
  if (good != 0) return shader;
  GLint length = 0;
  glGetShaderiv(shader.name(), GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
  glGetShaderInfoLog(shader.name(), length, nullptr, log.data());
  throw_compile_error(source, log);
}

}  // namespace

Program::Program(const std::filesystem::path& vertex_file, const std::filesystem::path& fragment_file) {
  const ShaderHandle vertex = compile(GL_VERTEX_SHADER, read_source(vertex_file));
  const ShaderHandle fragment = compile(GL_FRAGMENT_SHADER, read_source(fragment_file));
  handle_ = ProgramHandle(glCreateProgram());
  glAttachShader(handle_.name(), vertex.name());
  glAttachShader(handle_.name(), fragment.name());
  glLinkProgram(handle_.name());
  GLint good = 0;
  glGetProgramiv(handle_.name(), GL_LINK_STATUS, &good);
  if (good != 0) return;
  GLint length = 0;
  glGetProgramiv(handle_.name(), GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
  glGetProgramInfoLog(handle_.name(), length, &length, log.data());
  log.resize(static_cast<std::size_t>(length));  // without the null that ends it
  throw InputError(fragment_file, "", "does not fit " + vertex_file.filename().string() + ": " + log);
}

void Program::use() const {
  glUseProgram(handle_.name());
}

void Program::set(const char* uniform, int value) const {
  glUniform1i(glGetUniformLocation(handle_.name(), uniform), value);
}
void Program::set(const char* uniform, float value) const {
  glUniform1f(glGetUniformLocation(handle_.name(), uniform), value);
}
void Program::set(const char* uniform, const glm::vec2& value) const {
  glUniform2fv(glGetUniformLocation(handle_.name(), uniform), 1, glm::value_ptr(value));
}
void Program::set(const char* uniform, const glm::vec3& value) const {
  glUniform3fv(glGetUniformLocation(handle_.name(), uniform), 1, glm::value_ptr(value));
}
void Program::set(const char* uniform, const glm::vec4& value) const {
  glUniform4fv(glGetUniformLocation(handle_.name(), uniform), 1, glm::value_ptr(value));
}
void Program::set(const char* uniform, const glm::mat4& value) const {
  glUniformMatrix4fv(glGetUniformLocation(handle_.name(), uniform), 1, GL_FALSE, glm::value_ptr(value));
}

}  // namespace archetype::gl
