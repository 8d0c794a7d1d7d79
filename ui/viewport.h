// The view of the shape with its template.
#pragma once

#include <filesystem>

#include "render/camera.h"
#include "render/renderer.h"

namespace archetype {

struct Studio;

// What the viewport keeps from frame to frame. Needs the window's OpenGL context, also when it dies.
struct ViewportState {
  explicit ViewportState(const std::filesystem::path& shaders) : renderer(shaders) {}

  Renderer renderer;
  RenderTarget target;
  Camera camera;
  std::shared_ptr<const MeshGeometry> mesh;
  std::shared_ptr<const Colours> colours;
  std::uint64_t shape_revision = 0;
  std::uint64_t fit_revision = 0;
};

// Fills the current Dear ImGui window.
void draw_viewport(Studio& studio);

}  // namespace archetype
