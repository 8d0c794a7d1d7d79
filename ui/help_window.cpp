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

// The key, to be clicked and replaced; what is waited for, or in the way, while that goes on.
void draw_key(Studio& studio, const Command& command) {
  const KeyChange& change = studio.ui.key_change;
  const std::string name(command.name);
  if (change.command != name) {
    const std::string key = key_of(studio, command);
    if (ImGui::Selectable(((key.empty() ? "–" : key) + "##" + name).c_str())) wait_for_key(studio, name);
    mark_target(studio, "key:" + name);
    tooltip("Click, then press another key");
    return;
  }
  ImGui::PushStyleColor(ImGuiCol_Text, colours(studio).accent);
  ImGui::TextUnformatted(change.wanted ? to_string(*change.wanted).c_str() : "press a key…");
  ImGui::PopStyleColor();
  mark_target(studio, "key:" + name);
}

// Beside the title of a command whose key is being changed, or was.
void draw_key_answers(Studio& studio, const Command& command) {
  const KeyChange change = studio.ui.key_change;
  const std::string name(command.name);
  const auto answer = [&](const char* label) {
    const bool pressed = ImGui::SmallButton((std::string(label) + "##" + name).c_str());
    mark_target(studio, std::string("key:") + label + ":" + name);
    return pressed;
  };
  if (change.command == name) {
    if (change.wanted) {
      ImGui::PushStyleColor(ImGuiCol_Text, colours(studio).warning);
      ImGui::Text("is the key of “%s”", find_command(studio, change.taken_by)->title.data());
      ImGui::PopStyleColor();
      if (answer("Take it")) take_key_away(studio);
    } else if (answer("No key")) {
      studio.ui.key_change = {};
      set_key(studio, name, "");
    }
    ImGui::SameLine();
    if (answer("Cancel")) studio.ui.key_change = {};
  } else if (has_own_key(studio, name)) {
    ImGui::SameLine();
    if (answer("Reset")) reset_key(studio, name);
  }
}

void draw_menu(Studio& studio, std::string_view menu, const char* title) {
  section_title(studio, title);
  if (!ImGui::BeginTable(title, 3)) return;
  // Not by what is in them: then they would move when a key is changed.
  const float key_width = ImGui::CalcTextSize("Ctrl+Alt+Shift+PageDown").x;
  ImGui::TableSetupColumn("key", ImGuiTableColumnFlags_WidthFixed, key_width);
  ImGui::TableSetupColumn("title", ImGuiTableColumnFlags_WidthStretch, 1.2F);
  ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthStretch, 1);
  for (const Command& command : studio.commands) {
    if (command.menu != menu) continue;
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    draw_key(studio, command);
    ImGui::TableNextColumn();
    muted_text(studio, command.title);
    draw_key_answers(studio, command);
    ImGui::TableNextColumn();
    std::string usage(command.name);
    usage += ' ';
    usage += command.arguments;
    muted_text(studio, usage);
  }
  ImGui::EndTable();
}

}  // namespace

void draw_help_window(Studio& studio) {
  if (!studio.ui.help) {
    studio.ui.key_change = {};
    return;
  }
  const ImGuiViewport* screen = ImGui::GetMainViewport();
  const ImVec2 size(std::min(660 * studio.fonts.scale, screen->WorkSize.x * 0.9f),
                    screen->WorkSize.y * 0.85f);
  ImGui::SetNextWindowPos(screen->GetWorkCenter(), ImGuiCond_Appearing, {0.5f, 0.5f});
  ImGui::SetNextWindowSize(size, ImGuiCond_Appearing);
  if (ImGui::Begin("Keys and commands", &studio.ui.help, ImGuiWindowFlags_NoCollapse)) {
    muted_paragraph(
        studio,
        "Click a key to change it. The third column is the name for scripts. Ctrl+P finds a command by "
        "any of its words.");
    draw_mouse(studio);
    for (const char* menu : {"File", "Edit", "Template", "Part", "Points", "Shape", "View", "Window", "Help"})
      draw_menu(studio, menu, menu);
    draw_menu(studio, "", "Only in scripts and the palette");
  }
  ImGui::End();
}

}  // namespace archetype
