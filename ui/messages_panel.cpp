// The messages, newest at the bottom and in sight.
#include <imgui.h>

#include "ui/icons.h"
#include "ui/panels.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {

void draw_messages_panel(Studio& studio) {
  const auto& list = studio.messages.list();
  if (list.empty()) {
    empty_hint(studio, "No messages",
               "Files that could not be read, and anything else worth knowing, will stand here.");
    return;
  }
  const Palette& p = colours(studio);
  const bool at_end = ImGui::GetScrollY() >= ImGui::GetScrollMaxY();
  ImGui::PushTextWrapPos(0);
  for (const Message& message : list) {
    const bool error = message.severity == Severity::error;
    ImGui::PushStyleColor(ImGuiCol_Text, severity_colour(p, message.severity));
    ImGui::TextUnformatted(error                                   ? icon::error
                           : message.severity == Severity::warning ? icon::warning
                                                                   : icon::note);
    ImGui::PopStyleColor();
    ImGui::SameLine();
    ImGui::TextUnformatted(message.text.c_str());
  }
  ImGui::PopTextWrapPos();
  if (at_end) ImGui::SetScrollHereY(1.0f);
}

}  // namespace archetype
