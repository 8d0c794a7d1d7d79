// Textures, framebuffers and reading them back.
#include "render/gl/framebuffer.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <string>

#include "core/base/error.h"

namespace archetype::gl {
namespace {

TextureHandle make_texture(int width, int height, const void* pixels, GLint filter) {
  if (width < 1 || height < 1) throw PreconditionError("a texture needs at least one pixel");
  std::uint32_t name = 0;
  glGenTextures(1, &name);
  TextureHandle handle(name);
  glBindTexture(GL_TEXTURE_2D, name);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return handle;
}

}  // namespace

Texture::Texture(int width, int height)
    // Shown pixel for pixel. Without a graphics card a blend of four takes as long as all else in a frame.
    : handle_(make_texture(width, height, nullptr, GL_NEAREST)), width_(width), height_(height) {}

Texture::Texture(const Picture& picture)
    : handle_(make_texture(picture.width, picture.height, picture.pixels.data(), GL_LINEAR)),
      width_(picture.width),
      height_(picture.height) {}

void Texture::bind(int unit) const {
  glActiveTexture(static_cast<GLenum>(GL_TEXTURE0 + unit));
  glBindTexture(GL_TEXTURE_2D, name());
}

Framebuffer::Framebuffer(int width, int height) : colour_(width, height) {
  std::uint32_t name = 0;
  glGenRenderbuffers(1, &name);
  depth_ = RenderbufferHandle(name);
  glBindRenderbuffer(GL_RENDERBUFFER, name);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
  glGenFramebuffers(1, &name);
  handle_ = FramebufferHandle(name);
  const DrawInto here(*this);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour_.name(), 0);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.name());
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw Error("the graphics driver cannot draw into a picture of " + std::to_string(width) + " x " +
                std::to_string(height) + " pixels; ask for a smaller one");
}

Picture Framebuffer::read() const {
  const DrawInto here(*this);
  const std::size_t row = 4 * static_cast<std::size_t>(width());
  Picture picture{width(), height(), std::vector<std::uint8_t>(row * static_cast<std::size_t>(height()))};
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width(), height(), GL_RGBA, GL_UNSIGNED_BYTE, picture.pixels.data());
  // OpenGL's first row is the lowest.
  for (auto top = picture.pixels.begin(), bottom = picture.pixels.end();
       bottom - top > static_cast<long>(row);) {
    bottom -= static_cast<long>(row);
    std::swap_ranges(top, top + static_cast<long>(row), bottom);
    top += static_cast<long>(row);
  }
  return picture;
}

DrawInto::DrawInto(const Framebuffer& target) {
  glGetIntegerv(GL_FRAMEBUFFER_BINDING, &previous_framebuffer_);
  glGetIntegerv(GL_VIEWPORT, previous_viewport_);
  glBindFramebuffer(GL_FRAMEBUFFER, target.name());
  glViewport(0, 0, target.width(), target.height());
}

DrawInto::~DrawInto() {
  glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(previous_framebuffer_));
  glViewport(previous_viewport_[0], previous_viewport_[1], previous_viewport_[2], previous_viewport_[3]);
}

int largest_framebuffer_side() {
  GLint texture = 0;
  GLint renderbuffer = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &texture);
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &renderbuffer);
  return std::min(texture, renderbuffer);
}

}  // namespace archetype::gl
