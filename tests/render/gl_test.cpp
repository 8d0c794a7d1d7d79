// The layer above OpenGL: errors that help, objects that are freed.
#include <doctest/doctest.h>

#include <fstream>
#include <glm/vec4.hpp>

#include "core/base/error.h"
#include "render/gl/draw.h"
#include "render/gl/framebuffer.h"
#include "render/gl/headless_context.h"
#include "render/gl/program.h"
#include "scenes.h"

using namespace archetype;

namespace {

struct ShaderFolder {
  std::filesystem::path path = std::filesystem::path(ARCHETYPE_BINARY_DIR) / "shader_test";
  ShaderFolder() { std::filesystem::create_directories(path); }
  ~ShaderFolder() { std::filesystem::remove_all(path); }
  std::filesystem::path write(const char* name, const char* text) const {
    std::ofstream(path / name) << text;
    return path / name;
  }
};

std::string error_of(const std::filesystem::path& vertex, const std::filesystem::path& fragment) {
  try {
    const gl::Program program(vertex, fragment);
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace

TEST_CASE("a shader that does not compile is told by file and line, also in an included file") {
  const gl::HeadlessContext context;
  const ShaderFolder folder;
  const auto good =
      folder.write("good.vert", "#version 330 core\nvoid main() { gl_Position = vec4(0.0); }\n");
  const auto bad =
      folder.write("bad.frag", "#version 330 core\nout vec4 c;\nvoid main() { c = nonsense; }\n");
  CHECK(error_of(good, bad).find("bad.frag, line 3: ") != std::string::npos);

  folder.write("part.glsl", "float one() { return 1.0; }\nfloat two() { return }\n");
  const auto includes = folder.write(
      "includes.frag",
      "#version 330 core\n#include \"part.glsl\"\nout vec4 c;\nvoid main() { c = vec4(one()); }\n");
  CHECK(error_of(good, includes).find("part.glsl, line 2: ") != std::string::npos);

  folder.write("part.glsl", "float one() { return 1.0; }\n");
  CHECK(error_of(good, includes) == "no error");
  const auto after = folder.write(
      "after.frag", "#version 330 core\n#include \"part.glsl\"\n\nfloat f() { return nonsense; }\n");
  CHECK(error_of(good, after).find("after.frag, line 4: ") != std::string::npos);

  CHECK(error_of(good, folder.path / "gone.frag").find("gone.frag: cannot read") != std::string::npos);
}

TEST_CASE("shaders that do not fit each other are told apart from those that do not compile") {
  const gl::HeadlessContext context;
  const ShaderFolder folder;
  const auto vertex = folder.write(
      "a.vert", "#version 330 core\nout vec2 v;\nvoid main() { v = vec2(1.0); gl_Position = vec4(0.0); }\n");
  const auto fragment = folder.write(
      "b.frag", "#version 330 core\nin vec3 v;\nout vec4 c;\nvoid main() { c = vec4(v, 1.0); }\n");
  CHECK(error_of(vertex, fragment).find("does not fit a.vert") != std::string::npos);
}

TEST_CASE("a framebuffer is read with its top row first, and drawing elsewhere is restored") {
  const gl::HeadlessContext context;
  const gl::Framebuffer outer(5, 7);
  const gl::Framebuffer inner(2, 3);
  const gl::DrawInto outer_scope(outer);
  {
    const gl::DrawInto inner_scope(inner);
    gl::clear(glm::vec4(1, 0, 0, 1));
  }
  gl::clear(glm::vec4(0, 1, 0, 1));
  const Picture green = outer.read();
  CHECK(green.width == 5);
  CHECK(green.height == 7);
  CHECK(pixel_of(green, 4, 6) == Rgb{0, 255, 0});
  CHECK(pixel_of(inner.read(), 1, 2) == Rgb{255, 0, 0});
}

TEST_CASE("OpenGL errors are reported once") {
  const gl::HeadlessContext context;
  const gl::VertexArray vertices;
  gl::draw_triangles(vertices, static_cast<std::size_t>(-1));
  CHECK_THROWS_AS(gl::check_errors("drawing a negative number of corners"), Error);
  CHECK_NOTHROW(gl::check_errors("doing nothing"));
}

TEST_CASE("contexts come and go") {
  for (int i = 0; i < 3; ++i) {
    const gl::HeadlessContext context;
    CHECK_NOTHROW(gl::check_errors("opening a context"));
  }
}
