// What the program measures of itself.
#include <imgui.h>

#include <cstdio>
#include <vector>

#include "ui/panels.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

void line(const Studio& studio, const char* name, const std::string& value) {
  muted_text(studio, name);
  ImGui::SameLine(170 * studio.fonts.scale);
  ImGui::TextUnformatted(value.c_str());
}

std::string milliseconds(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f ms", value);
  return text;
}

}  // namespace

void draw_diagnostics_panel(Studio& studio) {
  const auto median = studio.latency.percentile(0.5);
  if (median) {
    line(studio, "Edit to displayed fit",
         "median " + milliseconds(*median) + ", 95th percentile " +
             milliseconds(*studio.latency.percentile(0.95)) + ", of " +
             std::to_string(studio.latency.milliseconds().size()) + " edits");
  } else {
    line(studio, "Edit to displayed fit", "not measured yet: drag a box of a shape in view");
  }
  if (const auto middle = studio.strip.latency.percentile(0.5))
    line(studio, "Edit to displayed strip",
         "median " + milliseconds(*middle) + ", 95th percentile " +
             milliseconds(*studio.strip.latency.percentile(0.95)) + ", of " +
             std::to_string(studio.strip.latency.milliseconds().size()) + " edits; last fits " +
             milliseconds(studio.strip.fit_milliseconds));
  line(studio, "Last fit",
       milliseconds(studio.live_fit.fit_milliseconds) + ", labels of the faces " +
           milliseconds(studio.live_fit.label_milliseconds));
  if (const auto middle = percentile(studio.frames.milliseconds(), 0.5))
    line(studio, "Frames",
         "median " + milliseconds(*middle) + ", 95th percentile " +
             milliseconds(*percentile(studio.frames.milliseconds(), 0.95)) + ", of the last " +
             std::to_string(studio.frames.milliseconds().size()));
  if (const std::optional<double>& took = studio.opening.milliseconds())
    line(studio, "Opening", milliseconds(*took) + " to the first frame");
  if (studio.ui.shown.revision > 0)
    line(studio, "Filter",
         milliseconds(studio.ui.shown.milliseconds) + " for " + count_text(studio.collection.rows().size()) +
             " shapes");
  if (const auto memory = resident_memory()) line(studio, "Memory", count_text(*memory / 1'000'000) + " MB");
  if (!median) return;
  const std::vector<float> values(studio.latency.milliseconds().begin(), studio.latency.milliseconds().end());
  ImGui::PlotLines("##latency", values.data(), static_cast<int>(values.size()), 0, nullptr, 0, 200,
                   {ImGui::GetContentRegionAvail().x, 48 * studio.fonts.scale});
  tooltip("Milliseconds from an edit to its fit on the screen, newest on the right; the height is 200 ms.");
}

}  // namespace archetype
