// Draws scenes.
#pragma once

#include <filesystem>
#include <optional>

#include "render/camera.h"
#include "render/gl/framebuffer.h"
#include "render/gl/program.h"
#include "render/scene.h"
#include "render/uploads.h"

namespace archetype {

// A piece of a larger picture: how large that is, and where the piece lies in it, from its upper left corner.
// All in pixels; a width of 0: the picture is whole.
struct PieceOfPicture {
  int whole_width = 0;
  int whole_height = 0;
  int left = 0;
  int top = 0;
  friend bool operator==(const PieceOfPicture&, const PieceOfPicture&) = default;
};

struct PictureSize {
  int width = 1;  // pixels
  int height = 1;
  int supersample = 1;   // 1 to 4: pixels are drawn that many times finer each way and averaged
  float line_scale = 1;  // pixels per unit of line widths: the scale of a HiDPI screen
  PieceOfPicture piece = {};
  friend bool operator==(const PictureSize&, const PictureSize&) = default;
};

// What a scene is drawn into; keeps its textures while the size stays.
class RenderTarget {
 public:
  // The picture drawn last; its first row is the lowest, as OpenGL has it. Needs a picture to have been
  // drawn.
  const gl::Texture& texture() const { return result().colour(); }
  Picture read() const { return result().read(); }
  const PictureSize& size() const { return size_; }

 private:
  friend class Renderer;
  const gl::Framebuffer& result() const { return reduced_ ? *reduced_ : *drawn_; }

  PictureSize size_;
  std::optional<gl::Framebuffer> drawn_;
  std::optional<gl::Framebuffer> reduced_;  // with supersampling
};

class Renderer {
 public:
  // Needs a current OpenGL 3.3 context, here, in every call, and when it dies. Throws FileError or InputError
  // where a shader is missing or does not compile.
  explicit Renderer(const std::filesystem::path& shader_folder);

  // Sizes are limited to what the graphics card can do. A 20,000-face mesh with 12 boxes takes a few ms in
  // 1280 x 720 in software.
  void draw(const Scene& scene, const Camera& camera, const PictureSize& size, RenderTarget& target);

  // Only the points of a scene, over what the target holds: clouds that take too long for one frame come into
  // their picture part by part (ScenePoints::first). Needs a target drawn by draw() without supersampling,
  // and the same camera.
  void draw_more_points(const Scene& scene, const Camera& camera, RenderTarget& target);

  std::size_t uploaded_bytes() const { return uploads_.byte_count(); }

 private:
  struct View;
  void resize(const PictureSize& size, RenderTarget& target) const;
  void draw_backdrop(const Scene& scene) const;
  void draw_meshes(const Scene& scene, const View& view);
  void draw_points(const Scene& scene, const View& view, bool behind);
  void draw_grid(const Scene& scene, const View& view) const;
  void draw_faces(const Scene& scene, const View& view);
  void draw_lines(const Scene& scene, const View& view);

  gl::Program mesh_;
  gl::Program points_;
  gl::Program lines_;
  gl::Program faces_;
  gl::Program grid_;
  gl::Program backdrop_;
  gl::Program reduce_;
  gl::VertexArray nothing_;  // for what the vertex shader makes up itself
  gl::Buffer face_buffer_;
  gl::VertexArray face_vertices_;
  gl::Buffer line_buffer_;
  gl::VertexArray line_vertices_;
  Uploads uploads_;
};

}  // namespace archetype
