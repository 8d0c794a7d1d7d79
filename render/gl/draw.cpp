// The state of the pipeline and the draw calls.
#include "render/gl/draw.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <glm/vec4.hpp>
#include <string>
#include <string_view>

#include "core/base/error.h"

namespace archetype::gl {
namespace {

void enable(GLenum capability, bool on) {
  on ? glEnable(capability) : glDisable(capability);
}

}  // namespace

void apply(const DrawState& state) {
  // The window's own drawing (Dear ImGui's back end) shares the context: nothing is assumed to be as we left
  // it.
  enable(GL_DEPTH_TEST, state.depth_test != DepthTest::off);
  glDepthFunc(state.depth_test == DepthTest::behind ? GL_GREATER : GL_LEQUAL);
  glDepthMask(state.depth_write ? GL_TRUE : GL_FALSE);
  enable(GL_BLEND, state.blend);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glDisable(GL_CULL_FACE);
  glDisable(GL_SCISSOR_TEST);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glEnable(GL_PROGRAM_POINT_SIZE);
}

void clear(const glm::vec4& colour) {
  apply({});
  glClearColor(colour.r, colour.g, colour.b, colour.a);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

bool in_software() {
  const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  constexpr std::array rasterizers{"llvmpipe", "softpipe", "swrast", "SWR"};
  return name && std::ranges::any_of(rasterizers, [&](const char* each) {
           return std::string_view(name).find(each) != std::string_view::npos;
         });
}

void finish() {
  glFinish();
}

void draw_triangles(const VertexArray& vertices, std::size_t vertex_count) {
  glBindVertexArray(vertices.name());
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertex_count));
}

void draw_points(const VertexArray& vertices, std::size_t first, std::size_t vertex_count) {
  glBindVertexArray(vertices.name());
  glDrawArrays(GL_POINTS, static_cast<GLint>(first), static_cast<GLsizei>(vertex_count));
}

void draw_quads(const VertexArray& vertices, std::size_t instance_count) {
  glBindVertexArray(vertices.name());
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(instance_count));
}

void check_errors(const char* what) {
  const GLenum first = glGetError();
  if (first == GL_NO_ERROR) return;
  while (glGetError() != GL_NO_ERROR) {
  }
  throw Error("OpenGL error " + std::to_string(first) + " while " + what +
              (first == GL_OUT_OF_MEMORY ? ": out of graphics memory" : ""));
}

}  // namespace archetype::gl
