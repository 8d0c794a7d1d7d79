#include "ui/headless_window.h"

#include <imgui_impl_opengl3.h>

#include <utility>

#include "render/gl/draw.h"

namespace archetype {
namespace {

void draw_into(const gl::Framebuffer& target) {
  const gl::DrawInto here(target);
  draw_built_frame();
}

}  // namespace

HeadlessWindow::HeadlessWindow(int width, int height, float scale, StudioOptions options)
    : HeadlessWindow(gl::HeadlessTurn(), width, height, scale, std::move(options)) {}

HeadlessWindow::HeadlessWindow(const gl::HeadlessTurn&, int width, int height, float scale,
                               StudioOptions options)
    : target_(width, height), studio_(std::move(options)), scale_(scale) {
  // There is no keyboard with codes of its own: Dear ImGui's keys are their own codes.
  for (int key = 0; key < ImGuiKey_COUNT; ++key) ImGui::GetIO().KeyMap[key] = key;
}

void HeadlessWindow::frame() {
  const gl::HeadlessTurn turn;
  imgui_.follow_settings(studio_, scale_);
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(target_.width()), static_cast<float>(target_.height())};
  io.DeltaTime = 1.0f / 60;  // no clock: what is drawn is the same each time
  ImGui_ImplOpenGL3_NewFrame();
  build_frame(studio_);
  draw_into(target_);
  gl::finish();  // as a screen would show it: the measured latencies end here
  frame_shown(studio_);
}

Picture HeadlessWindow::picture() const {
  const gl::HeadlessTurn turn;
  return target_.read();
}

Picture picture_of_frame() {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
  const gl::Framebuffer target(static_cast<int>(size.x * scale.x), static_cast<int>(size.y * scale.y));
  draw_into(target);
  return target.read();
}

}  // namespace archetype
