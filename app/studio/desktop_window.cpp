#include "app/studio/desktop_window.h"

#include <GLFW/glfw3.h>
#include <imgui_impl_glfw.h>
#include <imgui_impl_opengl3.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <utility>

#include "core/base/error.h"
#include "ui/command.h"

namespace archetype {
namespace {

std::string glfw_error() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text ? text : "unknown reason";
}

// A screen smaller than the window would hide its right side, where the template is.
void fit_on_screen(GLFWwindow* window) {
  GLFWmonitor* monitor = glfwGetPrimaryMonitor();
  if (!monitor) return;
  int x = 0;
  int y = 0;
  int room_x = 0;
  int room_y = 0;
  glfwGetMonitorWorkarea(monitor, &x, &y, &room_x, &room_y);
  int width = 0;
  int height = 0;
  glfwGetWindowSize(window, &width, &height);
  if (room_x <= 0 || room_y <= 0 || (width <= room_x && height <= room_y)) return;
  glfwSetWindowPos(window, x, y);
  glfwSetWindowSize(window, std::min(width, room_x), std::min(height, room_y));
}

GLFWwindow* open_window(int width, int height) {
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
  glfwWindowHintString(GLFW_X11_CLASS_NAME, "archetype-studio");
  GLFWwindow* window = glfwCreateWindow(width, height, "Archetype", nullptr, nullptr);
  if (!window)
    throw Error("no window with OpenGL 3.3 can be opened (" + glfw_error() +
                "); update the graphics driver, or use --screenshot and --quit without a display");
  glfwMakeContextCurrent(window);
  glfwSwapInterval(1);
  glfwSetWindowSizeLimits(window, 640, 400, GLFW_DONT_CARE, GLFW_DONT_CARE);
  fit_on_screen(window);
  glfwShowWindow(window);
  return window;
}

float content_scale(GLFWwindow* window) {
  float x = 1;
  float y = 1;
  glfwGetWindowContentScale(window, &x, &y);
  return std::clamp(std::max(x, y), 0.5f, 4.0f);
}

}  // namespace

DesktopWindow::Glfw::Glfw() {
  if (!glfwInit()) throw Error("no display can be opened (" + glfw_error() + ")");
}

DesktopWindow::Glfw::~Glfw() {
  glfwTerminate();
}

void DesktopWindow::DestroyWindow::operator()(GLFWwindow* window) const {
  glfwDestroyWindow(window);
}

bool DesktopWindow::display_available() {
  const auto named = [](const char* variable) {
    const char* value = std::getenv(variable);
    return value != nullptr && *value != 0;
  };
  return named("DISPLAY") || named("WAYLAND_DISPLAY");
}

DesktopWindow::DesktopWindow(int width, int height, StudioOptions options)
    : window_(open_window(width, height)) {
  imgui_.emplace();
  GLFWwindow* window = window_.get();
  glfwSetWindowUserPointer(window, this);
  // The keys come through our own queue; the rest is the back end's.
  ImGui_ImplGlfw_InitForOpenGL(window, true);
  glfwSetKeyCallback(window, on_key);
  glfwSetCharCallback(window, on_char);
  glfwSetDropCallback(window, on_drop);
  options.wake = glfwPostEmptyEvent;
  studio_.emplace(std::move(options));
}

DesktopWindow::~DesktopWindow() {
  studio_.reset();
  ImGui_ImplGlfw_Shutdown();
  imgui_.reset();
}

void DesktopWindow::on_key(GLFWwindow* window, int key, int scancode, int action, int mods) {
  auto& self = *static_cast<DesktopWindow*>(glfwGetWindowUserPointer(window));
  const KeyFeed::Event event{key, scancode, action, mods};
  self.keys_.add(event);
  if (const auto chord = chord_of(event)) self.studio_->pressed_keys.push_back(*chord);
}

void DesktopWindow::on_char(GLFWwindow* window, unsigned character) {
  static_cast<DesktopWindow*>(glfwGetWindowUserPointer(window))->keys_.add({0, 0, 0, 0, character});
}

void DesktopWindow::on_drop(GLFWwindow* window, int count, const char** paths) {
  auto& self = *static_cast<DesktopWindow*>(glfwGetWindowUserPointer(window));
  for (int i = 0; i < count; ++i) {
    const std::string arguments[] = {paths[i]};
    run_command(*self.studio_, "open", arguments);
  }
}

void DesktopWindow::hide() {
  glfwHideWindow(window_.get());
}

bool DesktopWindow::take_close_wish() {
  const bool wanted = glfwWindowShouldClose(window_.get()) != 0;
  glfwSetWindowShouldClose(window_.get(), GLFW_FALSE);
  return wanted;
}

// Nothing is drawn while nothing changes. Something that runs by itself wakes the loop when it has news; now
// and then a frame shows how the time goes on.
void DesktopWindow::wait_for_events() {
  constexpr double idle_seconds = 5;
  constexpr double running_seconds = 0.25;
  if (frames_to_draw_ > 0 || keys_waiting_ || studio_->drag || studio_->viewport.flying()) {
    glfwPollEvents();
    --frames_to_draw_;
    return;
  }
  glfwWaitEventsTimeout(wants_frames(*studio_) ? running_seconds : idle_seconds);
  frames_to_draw_ = 3;
}

void DesktopWindow::frame() {
  wait_for_events();
  keys_waiting_ = keys_.feed(window_.get());
  GLFWwindow* window = window_.get();
  imgui_->follow_settings(*studio_, content_scale(window));
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  build_frame(*studio_);
  draw_built_frame();
  glfwSwapBuffers(window);
  frame_shown(*studio_);
  int width = 0;
  int height = 0;
  glfwGetWindowSize(window, &width, &height);
  if (width > 0 && height > 0) {
    studio_->settings.window_width = width;
    studio_->settings.window_height = height;
  }
}

}  // namespace archetype
