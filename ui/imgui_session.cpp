#include "ui/imgui_session.h"

#include <imgui_impl_opengl3.h>

#include <algorithm>
#include <cmath>
#include <glm/vec4.hpp>

#include "render/gl/draw.h"
#include "ui/frame.h"
#include "ui/shortcuts.h"
#include "ui/studio.h"

namespace archetype {

ImGuiSession::ImGuiSession() : context_(ImGui::CreateContext()) {
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // the program's own settings say where things stand
  io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
  io.ConfigWindowsMoveFromTitleBarOnly = true;
  ImGui_ImplOpenGL3_Init("#version 330 core");
}

ImGuiSession::~ImGuiSession() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui::DestroyContext(context_);
}

void ImGuiSession::follow_settings(Studio& studio, float screen_scale) {
  const auto own_scale = static_cast<float>(studio.settings.ui_scale);
  const float scale = std::clamp(own_scale > 0 ? own_scale : screen_scale, 0.5F, 4.0F);
  const bool other_scale = !studio.fonts.regular || std::abs(studio.fonts.scale - scale) > 0.01f;
  if (!studio.wanted_fonts && !other_scale) return;
  studio.wanted_fonts = false;
  studio.theme = parse_theme(studio.settings.theme);
  apply_theme(studio.theme, scale);
  if (!other_scale) return;
  studio.fonts = load_fonts(scale);
  ImGui_ImplOpenGL3_DestroyFontsTexture();
  ImGui_ImplOpenGL3_CreateFontsTexture();
  for (const std::string& font : studio.fonts.missing)
    studio.messages.note("font " + font +
                         " is missing; install fonts-roboto-unhinted and fonts-font-awesome");
}

void build_frame(Studio& studio) {
  begin_frame(studio);
  ImGui::NewFrame();
  run_shortcuts(studio);
  draw_frame(studio);
  end_frame(studio);
  ImGui::Render();
}

void draw_built_frame() {
  const ImVec4& panel = ImGui::GetStyle().Colors[ImGuiCol_WindowBg];
  gl::clear({panel.x, panel.y, panel.z, 1});
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace archetype
