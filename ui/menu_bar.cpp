// The menus: the command table, in its order.
#include <imgui.h>

#include <limits>

#include "ui/centre_views.h"
#include "ui/panels.h"
#include "ui/project_actions.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

void draw_recent(Studio& studio) {
  if (!ImGui::BeginMenu("Open recent", !studio.settings.recent.empty())) return;
  const std::vector<std::string> recent = studio.settings.recent;  // opening one changes the list
  for (const std::string& path : recent) {
    const std::string arguments[] = {path};
    if (ImGui::MenuItem(path.c_str())) run_command(studio, "open", arguments);
  }
  ImGui::EndMenu();
}

void draw_starting_templates(Studio& studio) {
  if (!ImGui::BeginMenu("Start from")) return;
  for (const std::string& name : starting_templates(studio)) {
    const std::string arguments[] = {name};
    if (ImGui::MenuItem(name.c_str())) run_command(studio, "start-template", arguments);
  }
  ImGui::EndMenu();
}

}  // namespace

void draw_menu_bar(Studio& studio) {
  if (!ImGui::BeginMainMenuBar()) return;
  for (const char* menu : {"File", "Edit", "Template", "Part", "Points", "Shape", "View", "Window", "Help"}) {
    // Below the bar and never over it, or the click that opens a long menu would choose what comes to lie
    // under it.
    const float room = ImGui::GetMainViewport()->Size.y - ImGui::GetWindowHeight() -
                       ImGui::GetStyle().DisplaySafeAreaPadding.y;
    ImGui::SetNextWindowSizeConstraints(ImVec2(0, 0), ImVec2(std::numeric_limits<float>::max(), room));
    const bool open = ImGui::BeginMenu(menu);
    mark_target(studio, std::string("menu:") + menu);
    if (!open) continue;
    for (const Command& command : studio.commands) {
      if (command.menu != menu) continue;
      command_menu_item(studio, command);
      if (command.name == "open-project") draw_recent(studio);
      if (command.name == "new-template") draw_starting_templates(studio);
    }
    ImGui::EndMenu();
  }
  draw_centre_tabs(studio);
  ImGui::EndMainMenuBar();
}

}  // namespace archetype
