#include "ui/histogram_plot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

struct Axis {
  double low = 0;
  double high = 1;
  float left = 0;
  float width = 1;
  float at(double value) const {
    return left + width * static_cast<float>(std::clamp((value - low) / (high - low), 0.0, 1.0));
  }
  double value(float x) const {
    return low + (high - low) * static_cast<double>(std::clamp((x - left) / width, 0.0f, 1.0f));
  }
};

void draw_bars(ImDrawList& draw, const Histogram& histogram, std::size_t most, ImVec2 low, ImVec2 size,
               ImU32 colour) {
  const auto bins = static_cast<float>(histogram.counts.size());
  for (std::size_t i = 0; i < histogram.counts.size(); ++i) {
    if (histogram.counts[i] == 0) continue;
    // The root, so that a bin of three shapes is seen beside one of three thousand.
    const double share = std::sqrt(static_cast<double>(histogram.counts[i]) / static_cast<double>(most));
    const float height = std::max(1.0f, size.y * static_cast<float>(share));
    const float left = low.x + size.x * static_cast<float>(i) / bins;
    const float right = low.x + size.x * static_cast<float>(i + 1) / bins;
    draw.AddRectFilled({left, low.y + size.y - height}, {std::max(left + 1, right - 1), low.y + size.y},
                       colour);
  }
}

void tell(const PlottedHistogram& plotted, const Axis& axis) {
  const Histogram& all = *plotted.all;
  const auto bins = static_cast<double>(all.counts.size());
  const double at = (axis.value(ImGui::GetIO().MousePos.x) - all.low) / (all.high - all.low);
  const auto bin = static_cast<std::size_t>(std::clamp(std::floor(at * bins), 0.0, bins - 1));
  const double step = (all.high - all.low) / bins;
  const double from = all.low + static_cast<double>(bin) * step;
  ImGui::SetTooltip("%s to %s\n%s of %s shapes shown\nDrag to keep a range, double click to let go of it",
                    plotted_number(from).c_str(), plotted_number(from + step).c_str(),
                    count_text(plotted.shown->counts[bin]).c_str(), count_text(all.counts[bin]).c_str());
}

}  // namespace

std::string plotted_number(double value) {
  if (value >= 100 && value == std::round(value) && value < 1e15)
    return count_text(static_cast<std::size_t>(value));
  char text[32];
  std::snprintf(text, sizeof text,
                std::abs(value) >= 100  ? "%.0f"
                : std::abs(value) >= 10 ? "%.1f"
                                        : "%.3f",
                value);
  return text;
}

Brushed draw_histogram(Studio& studio, const std::string& target, const PlottedHistogram& plotted,
                       ImVec2 size, std::pair<double, double>& range) {
  const Palette& p = colours(studio);
  const float scale = studio.fonts.scale;
  const ImVec2 low = ImGui::GetCursorScreenPos();
  size = {std::max(size.x, 8.0f), std::max(size.y, 8.0f)};
  ImGui::InvisibleButton("##histogram", size);
  mark_target(studio, target);
  const Axis axis{plotted.all->low, plotted.all->high, low.x, size.x};
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(low, {low.x + size.x, low.y + size.y}, ImGui::GetColorU32(p.raised), 3 * scale);
  const std::size_t most = std::max<std::size_t>(1, std::ranges::max(plotted.all->counts));
  const ImVec4 quiet(p.muted.x, p.muted.y, p.muted.z, 0.35f);
  draw_bars(draw, *plotted.all, most, low, size, ImGui::GetColorU32(quiet));
  draw_bars(draw, *plotted.shown, most, low, size, ImGui::GetColorU32(p.accent));
  if (plotted.range) {
    const float from = axis.at(plotted.range->first);
    const float to = axis.at(plotted.range->second);
    const ImVec4 wash(p.accent.x, p.accent.y, p.accent.z, 0.14f);
    draw.AddRectFilled({from, low.y}, {to, low.y + size.y}, ImGui::GetColorU32(wash));
    for (const float x : {from, to})
      draw.AddLine({x, low.y}, {x, low.y + size.y}, ImGui::GetColorU32(p.text), std::max(1.0f, scale));
  }
  if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0)) return Brushed::cleared;
  constexpr float least_drag = 3;
  if (ImGui::IsItemActive() && ImGui::IsMouseDragging(0, least_drag * scale)) {
    const double a = axis.value(ImGui::GetIO().MouseClickedPos[0].x);
    const double b = axis.value(ImGui::GetIO().MousePos.x);
    // The outmost bins hold what lies beyond: an end that all but touches the edge is open.
    const double reach = axis.value(low.x + 4 * scale) - axis.value(low.x);
    range = {std::min(a, b) <= axis.low + reach ? -HUGE_VAL : std::min(a, b),
             std::max(a, b) >= axis.high - reach ? HUGE_VAL : std::max(a, b)};
    return Brushed::changed;
  }
  if (ImGui::IsItemHovered() && !ImGui::IsItemActive()) tell(plotted, axis);
  return Brushed::no;
}

}  // namespace archetype
