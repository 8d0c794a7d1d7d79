// Freeing of OpenGL objects.
#include "render/gl/handle.h"

#include <epoxy/gl.h>

namespace archetype::gl {

void delete_buffer(std::uint32_t name) {
  glDeleteBuffers(1, &name);
}
void delete_vertex_array(std::uint32_t name) {
  glDeleteVertexArrays(1, &name);
}
void delete_texture(std::uint32_t name) {
  glDeleteTextures(1, &name);
}
void delete_framebuffer(std::uint32_t name) {
  glDeleteFramebuffers(1, &name);
}
void delete_renderbuffer(std::uint32_t name) {
  glDeleteRenderbuffers(1, &name);
}
void delete_shader(std::uint32_t name) {
  glDeleteShader(name);
}
void delete_program(std::uint32_t name) {
  glDeleteProgram(name);
}

}  // namespace archetype::gl
