// Every step that can be undone; a click goes there.
#include <imgui.h>

#include <algorithm>

#include "ui/panels.h"
#include "ui/selection.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

// Where what was done or undone last lies out of sight.
void bring_into_sight(std::size_t row) {
  const float height = ImGui::GetTextLineHeightWithSpacing();
  const float top = ImGui::GetCursorPosY() + static_cast<float>(row) * height;
  const float room = ImGui::GetWindowHeight();
  if (top < ImGui::GetScrollY() || top + height > ImGui::GetScrollY() + room)
    ImGui::SetScrollY(std::max(0.0F, top - 0.5F * (room - height)));
}

}  // namespace

void draw_history_panel(Studio& studio) {
  const auto& entries = studio.history.entries();
  std::size_t wanted = studio.history.position();
  if (studio.ui.listed_revision != studio.history.committed_revision()) bring_into_sight(wanted);
  studio.ui.listed_revision = studio.history.committed_revision();
  const float edge = ImGui::GetStyle().ItemSpacing.x;  // by half of it rows are highlighted beyond their text
  ImGui::Indent(edge);
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(entries.size()));
  while (clipper.Step()) {
    for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row) {
      const auto entry = static_cast<std::size_t>(row);
      const bool undone = entry > studio.history.position();
      ImGui::PushID(row);
      if (undone) ImGui::PushStyleColor(ImGuiCol_Text, colours(studio).muted);
      if (ImGui::Selectable(entries[entry].message.c_str(), entry == studio.history.position()))
        wanted = entry;
      if (undone) ImGui::PopStyleColor();
      mark_target(studio, "history:" + std::to_string(entry));
      ImGui::PopID();
    }
  }
  ImGui::Unindent(edge);
  if (wanted != studio.history.position())
    step_through_history(studio, [&](History& history) { history.jump(wanted); });
}

}  // namespace archetype
