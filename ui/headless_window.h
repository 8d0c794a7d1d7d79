// The whole window without a display: for --screenshot, --script and tests. What is drawn repeats to the bit.
#pragma once

#include <memory>

#include "core/base/picture.h"
#include "render/gl/framebuffer.h"
#include "render/gl/headless_context.h"
#include "ui/imgui_session.h"
#include "ui/studio.h"

namespace archetype {

class HeadlessWindow {
 public:
  // Throws Error where OpenGL is missing.
  HeadlessWindow(int width, int height, float scale, StudioOptions options);

  Studio& studio() { return studio_; }
  // One frame, drawn; the mouse and the keys are those that were set in ImGui::GetIO() before.
  void frame();
  Picture picture() const;

 private:
  HeadlessWindow(const gl::HeadlessTurn& turn, int width, int height, float scale, StudioOptions options);

  gl::HeadlessContext context_;
  ImGuiSession imgui_;
  gl::Framebuffer target_;
  Studio studio_;
  float scale_;
};

// Draws what ImGui::Render() made into a framebuffer of its own and reads it. For the picture of a window.
Picture picture_of_frame();

}  // namespace archetype
