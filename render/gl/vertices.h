// Vertex data on the graphics card: buffers and the arrays that say how to read them.
#pragma once

#include <cstddef>
#include <span>

#include "render/gl/handle.h"

namespace archetype::gl {

class Buffer {
 public:
  Buffer();
  // Replaces the whole content.
  void upload(std::span<const std::byte> bytes);
  template <class T>
  void upload(std::span<const T> values) {
    upload(std::as_bytes(values));
  }

  std::size_t byte_count() const { return byte_count_; }
  std::uint32_t name() const { return handle_.name(); }

 private:
  BufferHandle handle_;
  std::size_t byte_count_ = 0;
};

enum class Component { float32, unorm8 };

// How one input of a vertex shader is read from a buffer.
struct Attribute {
  int location = 0;
  int components = 3;  // 1 to 4
  Component type = Component::float32;
  std::size_t stride = 0;  // bytes from one vertex to the next
  std::size_t offset = 0;  // bytes of the first
  bool per_instance = false;
};

class VertexArray {
 public:
  VertexArray();
  void attach(const Buffer& buffer, const Attribute& attribute);
  // The input gets the same value for all vertices: (0, 0, 0, 1) where nothing else is attached.
  void detach(int location);

  std::uint32_t name() const { return handle_.name(); }

 private:
  VertexArrayHandle handle_;
};

}  // namespace archetype::gl
