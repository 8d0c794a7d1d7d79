// The strip above the viewport: tools for boxes and what is drawn.
#include <imgui.h>

#include "ui/icons.h"
#include "ui/panels.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

void gap(const Studio& studio) {
  ImGui::SameLine(0, 8 * studio.fonts.scale);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetFrameHeight();
  ImGui::GetWindowDrawList()->AddLine({at.x, at.y + height * 0.2f}, {at.x, at.y + height * 0.8f},
                                      ImGui::GetColorU32(colours(studio).border), studio.fonts.scale);
  ImGui::SameLine(0, 9 * studio.fonts.scale);
}

}  // namespace

void draw_tool_bar(Studio& studio) {
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {2 * studio.fonts.scale, 0});
  command_button(studio, "undo", icon::undo);
  ImGui::SameLine();
  command_button(studio, "redo", icon::redo);
  gap(studio);
  command_toggle(studio, "tool-move", std::string(icon::move) + " Move");
  ImGui::SameLine();
  command_toggle(studio, "tool-scale", std::string(icon::scale) + " Scale");
  ImGui::SameLine();
  command_toggle(studio, "tool-rotate", std::string(icon::rotate) + " Rotate");
  ImGui::SameLine();
  command_toggle(studio, "snapping", std::string(icon::snap) + " Snap");
  gap(studio);
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
    gap(studio);
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
  ImGui::PopStyleVar();
}

}  // namespace archetype
