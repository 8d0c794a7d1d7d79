#include "ui/job_row.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "ui/icons.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

// `note` comes before what may be cut off.
std::string progress_text(const JobView& job, const std::string& note) {
  if (job.state == JobState::stopping) return "stopping…";
  std::string text = job.doing;
  const char* before_count = text.empty() ? "" : text.ends_with(':') ? " " : "  ·  ";
  if (job.total > 0) text += before_count + count_text(job.done) + " of " + count_text(job.total);
  if (job.state == JobState::paused) return text + (text.empty() ? "paused" : "  ·  paused") + note;
  if (job.seconds_left) text += "  ·  " + duration_text(*job.seconds_left) + " left of this step";
  return text + note + "  ·  " + duration_text(job.seconds) + " so far";
}

}  // namespace

void draw_active_job(Studio& studio, const JobView& job, const std::string& note) {
  const bool paused = job.state == JobState::paused;
  ImGui::PushID(static_cast<int>(job.id));
  ImGui::TextUnformatted(job.title.c_str());
  ImGui::SameLine();
  muted_text(studio, fitted(progress_text(job, note), ImGui::GetContentRegionAvail().x));
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float pause = ImGui::GetFrameHeight() * 3.4f;
  const float stop = ImGui::GetFrameHeight() * 2.6f;
  const float share = job.total > 0 ? static_cast<float>(job.done) / static_cast<float>(job.total) : -1.0f;
  const float height = ImGui::GetFrameHeight() * 0.32f;
  const ImVec2 at = ImGui::GetCursorPos();
  ImGui::SetCursorPosY(at.y + (ImGui::GetFrameHeight() - height) / 2);
  const float width = ImGui::GetContentRegionAvail().x - pause - stop - 2 * gap;
  // Without a total the bar runs to and fro: it says that something goes on, not how far.
  const float shown = share >= 0 ? share : 0.5f + 0.45f * static_cast<float>(std::sin(job.seconds * 2));
  if (paused) ImGui::PushStyleColor(ImGuiCol_PlotHistogram, colours(studio).muted);
  ImGui::ProgressBar(std::clamp(shown, 0.0f, 1.0f), {width, height}, "");
  if (paused) ImGui::PopStyleColor();
  ImGui::SameLine();
  ImGui::SetCursorPosY(at.y);
  ImGui::BeginDisabled(job.state == JobState::stopping);
  if (ImGui::Button(paused ? "Go on" : "Pause", {pause, 0})) {
    if (paused)
      studio.jobs.resume(job.id);
    else
      studio.jobs.pause(job.id);
  }
  mark_target(studio, "pause:" + job.title);
  ImGui::SameLine();
  if (ImGui::Button("Stop", {stop, 0})) studio.jobs.cancel(job.id);
  mark_target(studio, "stop:" + job.title);
  ImGui::EndDisabled();
  ImGui::PopID();
}

}  // namespace archetype
