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
  const float space = ImGui::GetContentRegionAvail().x;
  const float right_width = ImGui::CalcTextSize(right.c_str()).x;
  std::string left = studio.ui.status;
  if (left.empty()) left = "Ctrl+P finds every command, F1 lists the keys";
  muted_text(studio, fitted(left, space - right_width - 24 * studio.fonts.scale));
  ImGui::SameLine(ImGui::GetCursorPosX() + space - right_width);
  muted_text(studio, right);
}

}  // namespace archetype
