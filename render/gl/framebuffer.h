// Textures and what can be drawn into.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/base/picture.h"
#include "render/gl/handle.h"

namespace archetype::gl {

// An RGBA texture of 8 bits a channel, clamped at its edges; filtered linearly if made from a picture.
class Texture {
 public:
  Texture(int width, int height);            // to draw into; content undefined
  explicit Texture(const Picture& picture);  // the first row of the picture is the first of the texture

  int width() const { return width_; }
  int height() const { return height_; }
  std::uint32_t name() const { return handle_.name(); }
  void bind(int unit) const;

 private:
  TextureHandle handle_;
  int width_ = 0;
  int height_ = 0;
};

// A colour texture with depth, both of the same size.
class Framebuffer {
 public:
  Framebuffer(int width, int height);

  const Texture& colour() const { return colour_; }
  int width() const { return colour_.width(); }
  int height() const { return colour_.height(); }
  Picture read() const;
  std::uint32_t name() const { return handle_.name(); }

 private:
  Texture colour_;
  RenderbufferHandle depth_;
  FramebufferHandle handle_;
};

// Draws into a framebuffer for as long as it lives; then what was drawn into before, with its viewport, comes
// back.
class DrawInto {
 public:
  explicit DrawInto(const Framebuffer& target);
  DrawInto(const DrawInto&) = delete;
  DrawInto& operator=(const DrawInto&) = delete;
  ~DrawInto();

 private:
  int previous_framebuffer_ = 0;
  int previous_viewport_[4] = {};
};

// The largest width and height that a framebuffer may have.
int largest_framebuffer_side();

}  // namespace archetype::gl
