// The list of keys and commands, made from the command table.
#include <imgui.h>

#include "ui/panels.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

void row(const Studio& studio, const std::string& left, const std::string& right) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(left.c_str());
  ImGui::TableNextColumn();
  muted_text(studio, right);
}

void draw_mouse(const Studio& studio) {
  section_title(studio, "In the viewport");
  if (!ImGui::BeginTable("mouse", 2, ImGuiTableFlags_SizingStretchProp)) return;
  row(studio, "Drag on empty space", "orbit");
  row(studio, "Middle button, or Shift and drag", "pan");
  row(studio, "Wheel", "zoom to the cursor");
  row(studio, "Click a box", "select it; its handles move and resize it");
  row(studio, "Ctrl or Shift and click", "take a box into the selection, or out");
  row(studio, "Drag a dot, an arrow, a square",
      "resize against the other side, move along an axis, in a plane");
  row(studio, "Alt while resizing", "about the middle");
  row(studio, "Ctrl while dragging",
      "snap to the shape, other boxes, the symmetry plane, the ground, angles");
  row(studio, "Shift while dragging", "by steps of 0.05 or 15 degrees");
  row(studio, "X, Y, Z while dragging", "keep to that axis");
  row(studio, "G, S, R, then X, Y, Z, then a number", "move, scale, rotate by it; Enter keeps it");
  row(studio, "Esc while dragging", "put it back");
  ImGui::EndTable();
}

void draw_menu(const Studio& studio, std::string_view menu, const char* title) {
  section_title(studio, title);
  if (!ImGui::BeginTable(title, 3, ImGuiTableFlags_SizingStretchProp)) return;
  for (const Command& command : studio.commands) {
    if (command.menu != menu) continue;
    std::string usage(command.name);
    usage += ' ';
    usage += command.arguments;
    row(studio, key_of(studio, command), std::string(command.title));
    ImGui::TableNextColumn();
    muted_text(studio, usage);
  }
  ImGui::EndTable();
}

}  // namespace

void draw_help_window(Studio& studio) {
  if (!studio.ui.help) return;
  const ImGuiViewport* screen = ImGui::GetMainViewport();
  const ImVec2 size(std::min(660 * studio.fonts.scale, screen->WorkSize.x * 0.9f),
                    screen->WorkSize.y * 0.85f);
  ImGui::SetNextWindowPos(screen->GetWorkCenter(), ImGuiCond_Appearing, {0.5f, 0.5f});
  ImGui::SetNextWindowSize(size, ImGuiCond_Appearing);
  if (ImGui::Begin("Keys and commands", &studio.ui.help, ImGuiWindowFlags_NoCollapse)) {
    muted_paragraph(studio,
                    "The third column is the name for scripts. Ctrl+P finds a command by any of its words.");
    draw_mouse(studio);
    for (const char* menu : {"File", "Edit", "Template", "Part", "Points", "Shape", "View", "Window", "Help"})
      draw_menu(studio, menu, menu);
    draw_menu(studio, "", "Only in scripts and the palette");
  }
  ImGui::End();
}

}  // namespace archetype
