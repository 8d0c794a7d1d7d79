// The strip above the viewport: tools for boxes and what is drawn.
#include <imgui.h>

#include "ui/icons.h"
#include "ui/panels.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {
void draw_tool_bar(Studio& studio) {
  command_button(studio, "undo", icon::undo);
  ImGui::SameLine();
  command_button(studio, "redo", icon::redo);
  separator_in_line(studio);
  command_toggle(studio, "tool-move", std::string(icon::move) + " Move");
  ImGui::SameLine();
  command_toggle(studio, "tool-scale", std::string(icon::scale) + " Scale");
  ImGui::SameLine();
  command_toggle(studio, "tool-rotate", std::string(icon::rotate) + " Rotate");
  ImGui::SameLine();
  command_toggle(studio, "snapping", std::string(icon::snap) + " Snap");
  separator_in_line(studio);
  const std::pair<const char*, const char*> toggles[] = {
      {"surface", "Surface"}, {"wireframe", "Wires"},     {"points", "Points"},   {"part-colours", "Colours"},
      {"boxes", "Boxes"},     {"fitted-boxes", "Fitted"}, {"part-names", "Names"}};
  for (const auto& [command, label] : toggles) {
    const float width = ImGui::CalcTextSize(label).x + 2 * ImGui::GetStyle().FramePadding.x;
    if (ImGui::GetContentRegionAvail().x < width) break;  // rather than cut off
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
