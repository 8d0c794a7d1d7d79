// Fitting and jobs.
#include <cstdio>

#include "core/base/error.h"
#include "core/session/actions.h"
#include "ui/command_groups.h"
#include "ui/project_actions.h"
#include "ui/scripted_drag.h"
#include "ui/studio.h"

namespace archetype {
namespace {

std::string needs_jobs(const Studio& studio) {
  return studio.jobs.idle() ? "nothing is running" : "";
}

void fit_all_command(Studio& studio, Arguments) {
  fit_all(studio);
}

std::string needs_running_jobs(const Studio& studio) {
  if (studio.jobs.idle()) return "nothing is running";
  return studio.jobs.resting() ? "all jobs are paused" : "";
}

std::string needs_paused_jobs(const Studio& studio) {
  for (const JobView& job : studio.jobs.view())
    if (job.state == JobState::paused) return "";
  return "nothing is paused";
}

void cancel_jobs(Studio& studio, Arguments) {
  studio.jobs.cancel_all();
}

void pause_jobs(Studio& studio, Arguments) {
  studio.jobs.pause_all();
}

void resume_jobs(Studio& studio, Arguments) {
  studio.jobs.resume_all();
}

void wait_command(Studio&, Arguments) {}  // every command waits; this one does nothing else

void report_fit(Studio& studio, Arguments) {
  const ShapeFit& fit = studio.shape.fit->fit;
  std::size_t null_points = 0;
  for (const std::int16_t label : fit.labels) null_points += label == null_label;
  char line[512];
  std::snprintf(
      line, sizeof line,
      "fit %s: energy %.6f shape-to-template %.6f template-to-shape %.6f features %.6f deformation %.6f "
      "smoothness %.6f existence %.6f yaw %d alternations %d null %.4f",
      studio.shape.record->name.c_str(), fit.energy.total(), fit.energy.shape_to_template,
      fit.energy.template_to_shape, fit.energy.features, fit.energy.deformation, fit.energy.smoothness,
      fit.energy.existence, fit.yaw_quarters * 90, fit.alternations,
      static_cast<double>(null_points) / static_cast<double>(fit.labels.size()));
  studio.output.emplace_back(line);
}

void report_latency(Studio& studio, Arguments) {
  const auto median = studio.latency.percentile(0.5);
  if (!median) throw Error("no edit was followed by a fit yet; drag a box of a shape in view first");
  char line[256];
  std::snprintf(line, sizeof line,
                "latency: %zu edits, median %.1f ms, 95th percentile %.1f ms, longest %.1f ms",
                studio.latency.milliseconds().size(), *median, *studio.latency.percentile(0.95),
                *studio.latency.percentile(1));
  studio.output.emplace_back(line);
}

void report_frames(Studio& studio, Arguments) {
  const auto& frames = studio.frames.milliseconds();
  char line[256];
  std::snprintf(
      line, sizeof line,
      "frames: %zu, median %.1f ms, 95th percentile %.1f ms, longest %.1f ms, processor %.1f ms a frame",
      frames.size(), percentile(frames, 0.5).value_or(0), percentile(frames, 0.95).value_or(0),
      percentile(frames, 1).value_or(0), studio.frames.processor_milliseconds());
  studio.output.emplace_back(line);
}

// The same live edits as a drag with the mouse, one a frame.
void drag_part(Studio& studio, Arguments arguments) {
  ScriptedDrag drag;
  drag.part = *studio.ui.part;
  drag.from = studio.history.committed().active_template()->parts[drag.part].mean_box();
  drag.by = {number_argument(arguments, 0, "x y z frames"), number_argument(arguments, 1, "x y z frames"),
             number_argument(arguments, 2, "x y z frames")};
  drag.frames = static_cast<int>(number_argument(arguments, 3, "x y z frames"));
  if (drag.frames < 1 || drag.frames > 100'000) throw Error("expected from 1 to 100000 frames");
  studio.drag = drag;
}

void clear_latency(Studio& studio, Arguments) {
  studio.latency.clear();
  studio.strip.latency.clear();
  studio.frames.clear();
}

}  // namespace

void add_fit_commands(std::vector<Command>& commands) {
  commands.insert(
      commands.end(),
      {
          {.name = "fit-all",
           .title = "Fit the template to all shapes",
           .menu = "Shape",
           .key = "Ctrl+Enter",
           .run = fit_all_command,
           .why_not = needs_shapes_and_template,
           .separator = true},
          {.name = "pause-jobs",
           .title = "Pause all jobs",
           .menu = "Shape",
           .run = pause_jobs,
           .why_not = needs_running_jobs,
           .at_once = true},
          {.name = "resume-jobs",
           .title = "Let paused jobs go on",
           .menu = "Shape",
           .run = resume_jobs,
           .why_not = needs_paused_jobs,
           .at_once = true},
          {.name = "cancel-jobs",
           .title = "Stop all jobs",
           .menu = "Shape",
           .run = cancel_jobs,
           .why_not = needs_jobs,
           .at_once = true},
          {.name = "wait", .title = "Wait for what is under way", .run = wait_command},
          {.name = "drag-part",
           .title = "Drag the part",
           .arguments = "X Y Z FRAMES",
           .run = drag_part,
           .why_not = needs_part},
          {.name = "report-fit",
           .title = "Print the energy of the fit",
           .run = report_fit,
           .why_not = needs_fit},
          {.name = "report-latency", .title = "Print how fast fits follow edits", .run = report_latency},
          {.name = "report-frames", .title = "Print how long frames take", .run = report_frames},
          {.name = "clear-latency", .title = "Forget the measured times", .run = clear_latency},
      });
}

}  // namespace archetype
