// What runs beside the window, how far it is, and a button that stops it.
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "ui/icons.h"
#include "ui/panels.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

std::string progress_text(const JobView& job) {
  std::string text = job.doing;
  if (job.total > 0)
    text += (text.empty() ? "" : "  ") + count_text(job.done) + " of " + count_text(job.total);
  if (job.seconds_left) text += "  ·  " + duration_text(*job.seconds_left) + " left";
  return text;
}

const char* state_text(JobState state) {
  switch (state) {
    case JobState::running:
      return "running";
    case JobState::stopping:
      return "stopping…";
    case JobState::done:
      return "done";
    case JobState::cancelled:
      return "stopped";
    case JobState::failed:
      return "failed";
  }
  return "";
}

void draw_running(Studio& studio, const JobView& job) {
  ImGui::TextUnformatted(job.title.c_str());
  ImGui::SameLine();
  muted_text(studio, job.state == JobState::stopping ? state_text(job.state) : progress_text(job));
  const float button = ImGui::GetFrameHeight() * 2.6f;
  const float share = job.total > 0 ? static_cast<float>(job.done) / static_cast<float>(job.total) : -1.0f;
  const float height = ImGui::GetFrameHeight() * 0.32f;
  const ImVec2 at = ImGui::GetCursorPos();
  ImGui::SetCursorPosY(at.y + (ImGui::GetFrameHeight() - height) / 2);
  const float width = ImGui::GetContentRegionAvail().x - button - ImGui::GetStyle().ItemSpacing.x;
  // Without a total the bar runs to and fro: it says that something goes on, not how far.
  const float shown = share >= 0 ? share : 0.5f + 0.45f * static_cast<float>(std::sin(job.seconds * 2));
  ImGui::ProgressBar(std::clamp(shown, 0.0f, 1.0f), {width, height}, "");
  ImGui::SameLine();
  ImGui::SetCursorPosY(at.y);
  ImGui::BeginDisabled(job.state == JobState::stopping);
  if (ImGui::Button("Stop", {button, 0})) studio.jobs.cancel(job.id);
  ImGui::EndDisabled();
  mark_target(studio, "stop:" + job.title);
}

void draw_ended(Studio& studio, const JobView& job) {
  const Palette& p = colours(studio);
  const bool failed = job.state == JobState::failed;
  ImGui::PushStyleColor(ImGuiCol_Text, failed ? p.error : job.state == JobState::done ? p.good : p.muted);
  ImGui::TextUnformatted(failed ? icon::error : job.state == JobState::done ? icon::check : icon::close);
  ImGui::PopStyleColor();
  ImGui::SameLine();
  ImGui::TextUnformatted(job.title.c_str());
  ImGui::SameLine();
  muted_text(studio, std::string(state_text(job.state)) + " after " + duration_text(job.seconds));
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
               "Imports, fits of the whole collection and exports show here with their "
               "progress, the time left and a button that stops them.");
    return;
  }
  for (const JobView& job : jobs) {
    ImGui::PushID(static_cast<int>(job.id));
    if (job.active())
      draw_running(studio, job);
    else
      draw_ended(studio, job);
    ImGui::PopID();
  }
}

}  // namespace archetype
