// The line at the bottom: what was done last, what runs, what is in view.
#include <imgui.h>

#include "ui/panels.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {

void draw_status_bar(Studio& studio) {
  std::string right;
  for (const JobView& job : studio.jobs.view()) {
    if (!job.active()) continue;
    right = job.title;
    if (job.total > 0) right += "  " + count_text(job.done) + " of " + count_text(job.total);
    if (job.state == JobState::paused)
      right += "  ·  paused";
    else if (job.seconds_left)
      right += "  ·  " + duration_text(*job.seconds_left) + " left";
    break;
  }
  if (right.empty() && studio.shape.record) {
    right = studio.shape.record->name + "  ·  " + count_text(studio.shape.record->element_count) +
            (studio.shape.record->point_set ? " points" : " faces");
  }
  const Palette& p = colours(studio);
  // For as long as it lasts, whatever else is said meanwhile.
  const std::string& unsavable = studio.autosave.problem;
  if (!unsavable.empty()) right = "NOT SAVED";
  const float space = ImGui::GetContentRegionAvail().x;
  const float right_width = ImGui::CalcTextSize(right.c_str()).x;
  std::string left = studio.ui.status;
  if (!unsavable.empty()) left = unsavable;
  if (left.empty()) left = "Ctrl+P finds every command, F1 lists the keys";
  ImGui::PushStyleColor(ImGuiCol_Text, unsavable.empty() ? p.muted : p.error);
  ImGui::TextUnformatted(fitted(left, space - right_width - 24 * studio.fonts.scale).c_str());
  if (!unsavable.empty()) tooltip(unsavable.c_str());
  ImGui::SameLine(ImGui::GetCursorPosX() + space - right_width);
  ImGui::TextUnformatted(right.c_str());
  ImGui::PopStyleColor();
}

}  // namespace archetype
