// The window on a desktop (GLFW).
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "app/studio/key_feed.h"
#include "ui/imgui_session.h"
#include "ui/studio.h"

struct GLFWwindow;

namespace archetype {

class DesktopWindow {
 public:
  // Throws Error where no window with OpenGL 3.3 can be opened.
  DesktopWindow(int width, int height, StudioOptions options);
  DesktopWindow(const DesktopWindow&) = delete;
  DesktopWindow& operator=(const DesktopWindow&) = delete;
  ~DesktopWindow();

  static bool display_available();

  Studio& studio() { return *studio_; }
  // Waits for events, for as long as nothing changes by itself, then draws a frame.
  void frame();
  // From the screen, before the end.
  void hide();
  // Once for each time that its cross was pressed.
  bool take_close_wish();

 private:
  static void on_key(GLFWwindow* window, int key, int scancode, int action, int mods);
  static void on_char(GLFWwindow* window, unsigned character);
  static void on_drop(GLFWwindow* window, int count, const char** paths);
  void wait_for_events();

  struct Glfw {
    Glfw();
    ~Glfw();
  };
  struct DestroyWindow {
    void operator()(GLFWwindow* window) const;
  };
  Glfw glfw_;
  std::unique_ptr<GLFWwindow, DestroyWindow> window_;
  KeyFeed keys_;
  std::optional<ImGuiSession> imgui_;
  std::optional<Studio> studio_;
  int frames_to_draw_ = 3;  // Dear ImGui takes up to three to come to rest after an event
  bool keys_waiting_ = false;
};

}  // namespace archetype
