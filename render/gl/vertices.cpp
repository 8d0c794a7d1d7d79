// Vertex data on the graphics card.
#include "render/gl/vertices.h"

#include <epoxy/gl.h>

namespace archetype::gl {

Buffer::Buffer() {
  std::uint32_t name = 0;
  glGenBuffers(1, &name);
  handle_ = BufferHandle(name);
}

void Buffer::upload(std::span<const std::byte> bytes) {
  glBindBuffer(GL_ARRAY_BUFFER, name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), GL_DYNAMIC_DRAW);
  byte_count_ = bytes.size();
}

VertexArray::VertexArray() {
  std::uint32_t name = 0;
  glGenVertexArrays(1, &name);
  handle_ = VertexArrayHandle(name);
}

void VertexArray::attach(const Buffer& buffer, const Attribute& attribute) {
  const auto location = static_cast<GLuint>(attribute.location);
  const bool is_float = attribute.type == Component::float32;
  glBindVertexArray(name());
  glBindBuffer(GL_ARRAY_BUFFER, buffer.name());
  glEnableVertexAttribArray(location);
  glVertexAttribPointer(location, attribute.components, is_float ? GL_FLOAT : GL_UNSIGNED_BYTE,
                        is_float ? GL_FALSE : GL_TRUE, static_cast<GLsizei>(attribute.stride),
                        reinterpret_cast<const void*>(attribute.offset));
  glVertexAttribDivisor(location, attribute.per_instance ? 1 : 0);
}

void VertexArray::detach(int location) {
  glBindVertexArray(name());
  glDisableVertexAttribArray(static_cast<GLuint>(location));
}

}  // namespace archetype::gl
