// Shader programs, read from the files of shaders/.
#pragma once

#include <filesystem>
#include <glm/fwd.hpp>

#include "render/gl/handle.h"

namespace archetype::gl {

class Program {
 public:
  // Compiles and links two files. A line `#include "other.glsl"` takes in a file of the same folder (one
  // level). Throws FileError for a file that cannot be read and InputError (file, line, the driver's words)
  // for one that does not compile or fit the other.
  Program(const std::filesystem::path& vertex_file, const std::filesystem::path& fragment_file);

  void use() const;

  // Set a uniform of the program, which must be in use. Names that the program does not have are ignored:
  // drivers drop uniforms that do not matter.
  void set(const char* uniform, int value) const;
  void set(const char* uniform, float value) const;
  void set(const char* uniform, const glm::vec2& value) const;
  void set(const char* uniform, const glm::vec3& value) const;
  void set(const char* uniform, const glm::vec4& value) const;
  void set(const char* uniform, const glm::mat4& value) const;

 private:
  ProgramHandle handle_;
};

}  // namespace archetype::gl
