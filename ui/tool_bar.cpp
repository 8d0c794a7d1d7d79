// The strip above the viewport: tools for boxes and what is drawn.
#include <imgui.h>

#include <array>
#include <string>
#include <utility>

#include "ui/icons.h"
#include "ui/panels.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {

namespace {

struct Tool {
  const char* command;
  const char* icon;
  const char* word;
};

constexpr std::array tools{Tool{"tool-move", icon::move, "Move"}, Tool{"tool-scale", icon::scale, "Scale"},
                           Tool{"tool-rotate", icon::rotate, "Rotate"}, Tool{"snapping", icon::snap, "Snap"}};
constexpr std::array<std::pair<const char*, const char*>, 7> toggles{{{"surface", "Surface"},
                                                                      {"wireframe", "Wires"},
                                                                      {"points", "Points"},
                                                                      {"part-colours", "Colours"},
                                                                      {"boxes", "Boxes"},
                                                                      {"fitted-boxes", "Fitted"},
                                                                      {"part-names", "Names"}}};

std::string with_word(const Tool& tool) {
  return std::string(tool.icon) + " " + tool.word;
}

float button_width(const std::string& text) {
  return ImGui::CalcTextSize(text.c_str()).x + 2 * ImGui::GetStyle().FramePadding.x;
}

// Whether what is drawn can all be chosen beside tools that say in words what they are.
bool room_for_words(const Studio& studio) {
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  float width = separator_width(studio);
  for (const Tool& tool : tools) width += button_width(with_word(tool)) + gap;
  for (const auto& [command, label] : toggles) width += button_width(label) + gap;
  return ImGui::GetContentRegionAvail().x >= width;
}

}  // namespace

void draw_tool_bar(Studio& studio) {
  command_button(studio, "undo", icon::undo);
  ImGui::SameLine();
  command_button(studio, "redo", icon::redo);
  separator_in_line(studio);
  const bool words = room_for_words(studio);
  for (const Tool& tool : tools) {
    if (&tool != tools.data()) ImGui::SameLine();
    command_toggle(studio, tool.command, words ? with_word(tool) : tool.icon);
  }
  separator_in_line(studio);
  for (const auto& [command, label] : toggles) {
    if (ImGui::GetContentRegionAvail().x < button_width(label)) break;  // rather than cut off
    command_toggle(studio, command, label);
    ImGui::SameLine();
  }
  // The rest only where there is room: it has keys and menus too.
  const float room = ImGui::GetContentRegionAvail().x;
  if (room > 190 * studio.fonts.scale) {
    separator_in_line(studio);
    command_button(studio, "view-front", "Front");
    ImGui::SameLine();
    command_button(studio, "view-right", "Side");
    ImGui::SameLine();
    command_button(studio, "view-top", "Top");
    ImGui::SameLine();
    command_button(studio, "frame", "Frame");
  } else {
    ImGui::NewLine();
  }
}

}  // namespace archetype
