// Names of OpenGL objects that are freed with their owner.
#pragma once

#include <cstdint>
#include <utility>

namespace archetype::gl {

void delete_buffer(std::uint32_t name);
void delete_vertex_array(std::uint32_t name);
void delete_texture(std::uint32_t name);
void delete_framebuffer(std::uint32_t name);
void delete_renderbuffer(std::uint32_t name);
void delete_shader(std::uint32_t name);
void delete_program(std::uint32_t name);

// Owns one name; 0 is none. The context that made it has to be current when it dies.
template <void (*Delete)(std::uint32_t)>
class Handle {
 public:
  Handle() = default;
  explicit Handle(std::uint32_t name) : name_(name) {}
  Handle(Handle&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() {
    if (name_ != 0) Delete(name_);
  }

  std::uint32_t name() const { return name_; }

 private:
  std::uint32_t name_ = 0;
};

using BufferHandle = Handle<delete_buffer>;
using VertexArrayHandle = Handle<delete_vertex_array>;
using TextureHandle = Handle<delete_texture>;
using FramebufferHandle = Handle<delete_framebuffer>;
using RenderbufferHandle = Handle<delete_renderbuffer>;
using ShaderHandle = Handle<delete_shader>;
using ProgramHandle = Handle<delete_program>;

}  // namespace archetype::gl
