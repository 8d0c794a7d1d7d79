// Dear ImGui with its OpenGL back end, for as long as it lives.
#pragma once

#include <imgui.h>

namespace archetype {

struct Studio;

class ImGuiSession {
 public:
  ImGuiSession();  // needs a current OpenGL 3.3 context, also when it dies
  ImGuiSession(const ImGuiSession&) = delete;
  ImGuiSession& operator=(const ImGuiSession&) = delete;
  ~ImGuiSession();

  // Loads the fonts and applies the theme where the settings or the screen's scale ask for others than there
  // are.
  void follow_settings(Studio& studio, float screen_scale);

 private:
  ImGuiContext* context_;
};

// A whole frame but for getting it to the screen: to be called after the back ends' new frame.
void build_frame(Studio& studio);
// Draws it into the current framebuffer.
void draw_built_frame();

}  // namespace archetype
