// What runs beside the window, how far it is, and what has ended.
#include <imgui.h>

#include "ui/icons.h"
#include "ui/job_row.h"
#include "ui/panels.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

void draw_ended(Studio& studio, const JobView& job) {
  const Palette& p = colours(studio);
  const bool failed = job.state == JobState::failed;
  const std::string how = failed ? "failed" : job.state == JobState::done ? "done" : "stopped";
  ImGui::PushStyleColor(ImGuiCol_Text, failed ? p.error : job.state == JobState::done ? p.good : p.muted);
  ImGui::TextUnformatted(failed ? icon::error : job.state == JobState::done ? icon::check : icon::close);
  ImGui::PopStyleColor();
  ImGui::SameLine();
  ImGui::TextUnformatted(job.title.c_str());
  ImGui::SameLine();
  muted_text(studio, how + " after " + duration_text(job.seconds));
  if (failed) {
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(job.error.c_str());
    ImGui::PopTextWrapPos();
  }
}

}  // namespace

void draw_jobs_panel(Studio& studio) {
  const std::vector<JobView> jobs = studio.jobs.view();
  if (jobs.empty()) {
    empty_hint(studio, "Nothing is running",
               "Imports, fits of the whole collection and learning show here with their "
               "progress, the time left and buttons that pause and stop them.");
    return;
  }
  for (const JobView& job : jobs) {
    ImGui::PushID(static_cast<int>(job.id));
    if (job.active())
      draw_active_job(studio, job);
    else
      draw_ended(studio, job);
    ImGui::PopID();
  }
}

}  // namespace archetype
