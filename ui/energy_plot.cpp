#include "ui/energy_plot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/report/axis_marks.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

// Where values lie on the screen.
struct Axes {
  ImVec2 low;   // upper left corner of the plotted area
  ImVec2 high;  // lower right corner
  double least = 0;
  double most = 1;
  std::size_t rounds = 1;  // along the horizontal axis: from 0 to this

  float x(std::size_t round) const {
    return low.x + (high.x - low.x) * static_cast<float>(round) / static_cast<float>(rounds);
  }
  float y(double value) const {
    return high.y - (high.y - low.y) * static_cast<float>((value - least) / (most - least));
  }
};

void draw_axes(const Studio& studio, const Axes& axes, const std::vector<double>& marks) {
  const Palette& p = colours(studio);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float line = ImGui::GetTextLineHeight();
  const float scale = studio.fonts.scale;
  const ImU32 muted = ImGui::GetColorU32(p.muted);
  const ImU32 grid = ImGui::GetColorU32({p.muted.x, p.muted.y, p.muted.z, 0.25f});
  for (const double mark : marks) {
    const float y = axes.y(mark);
    draw.AddLine({axes.low.x, y}, {axes.high.x, y}, grid, scale);
    const std::string text = mark_text(mark, marks[1] - marks[0]);
    draw.AddText({axes.low.x - ImGui::CalcTextSize(text.c_str()).x - 6 * scale, y - line / 2}, muted,
                 text.c_str());
  }
  draw.AddLine({axes.low.x, axes.high.y}, axes.high, muted, scale);
  const float room = ImGui::CalcTextSize("000").x;
  const auto every = static_cast<std::size_t>(
      std::max(1.0f, std::ceil(room * static_cast<float>(axes.rounds) / (axes.high.x - axes.low.x))));
  for (std::size_t round = 0; round <= axes.rounds; round += every) {
    const std::string text = std::to_string(round);
    const float x = axes.x(round);
    draw.AddLine({x, axes.high.y}, {x, axes.high.y + 3 * scale}, muted, scale);
    draw.AddText({x - ImGui::CalcTextSize(text.c_str()).x / 2, axes.high.y + 3 * scale}, muted, text.c_str());
  }
}

void draw_curve(const Studio& studio, const Axes& axes, const std::vector<PlottedRound>& rounds,
                std::optional<std::size_t> chosen, std::optional<std::size_t> hovered) {
  const Palette& p = colours(studio);
  const float scale = studio.fonts.scale;
  const ImU32 accent = ImGui::GetColorU32(p.accent);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  if (hovered)
    draw.AddLine({axes.x(*hovered), axes.low.y}, {axes.x(*hovered), axes.high.y}, ImGui::GetColorU32(p.muted),
                 scale);
  std::vector<ImVec2> points;
  for (std::size_t i = 0; i < rounds.size(); ++i) points.emplace_back(axes.x(i), axes.y(rounds[i].energy));
  draw.AddPolyline(points.data(), static_cast<int>(points.size()), accent, 0, 2 * scale);
  for (std::size_t i = 0; i < points.size(); ++i) {
    draw.AddCircleFilled(points[i], (i == hovered ? 5 : 3.5f) * scale, accent);
    if (i == chosen) draw.AddCircle(points[i], 6.5f * scale, ImGui::GetColorU32(p.text), 0, 1.5f * scale);
  }
}

}  // namespace

std::optional<std::size_t> draw_energy_plot(Studio& studio, const std::vector<PlottedRound>& rounds,
                                            std::optional<std::size_t> chosen, ImVec2 size) {
  const float line = ImGui::GetTextLineHeight();
  const float scale = studio.fonts.scale;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool clicked = ImGui::InvisibleButton("##energy", size);
  mark_target(studio, "energy-plot");
  if (rounds.empty()) return std::nullopt;
  const auto [least, most] = std::ranges::minmax(rounds, {}, &PlottedRound::energy);
  const auto fitting = static_cast<std::size_t>(std::max(3.0f, (size.y - 2.5f * line) / (1.7f * line)));
  const std::vector<double> marks = axis_marks(least.energy, most.energy, fitting);
  float text = 0;
  for (const double mark : {marks.front(), marks.back()})
    text = std::max(text, ImGui::CalcTextSize(mark_text(mark, marks[1] - marks[0]).c_str()).x);
  Axes axes;
  axes.low = {at.x + text + 10 * scale, at.y + line * 0.6f};
  axes.high = {at.x + size.x - 10 * scale, at.y + size.y - line - 4 * scale};
  axes.least = marks.front();
  axes.most = marks.back();
  axes.rounds = std::max<std::size_t>(rounds.size() - 1, 5);
  draw_axes(studio, axes, marks);
  std::optional<std::size_t> hovered;
  if (ImGui::IsItemHovered()) {
    const float share = (ImGui::GetIO().MousePos.x - axes.low.x) / (axes.high.x - axes.low.x);
    const auto nearest = std::lround(std::max(0.0f, share) * static_cast<float>(axes.rounds));
    hovered = std::min(static_cast<std::size_t>(nearest), rounds.size() - 1);
  }
  draw_curve(studio, axes, rounds, chosen, hovered);
  if (!hovered) return std::nullopt;
  const PlottedRound& round = rounds[*hovered];
  ImGui::SetTooltip("%s\nenergy %.4f%s%s",
                    *hovered == 0 ? "start" : ("round " + std::to_string(*hovered)).c_str(), round.energy,
                    round.note.empty() ? "" : "\n", round.note.c_str());
  return clicked ? hovered : std::nullopt;
}

}  // namespace archetype
