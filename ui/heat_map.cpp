#include "ui/heat_map.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace archetype {
namespace {

// At even steps.
constexpr std::array<Rgb, 7> stops{Rgb{31, 12, 72},  Rgb{85, 15, 109},  Rgb{136, 34, 106}, Rgb{186, 54, 85},
                                   Rgb{227, 89, 51}, Rgb{249, 140, 10}, Rgb{252, 226, 120}};

template <typename Number>
std::shared_ptr<const Colours> colours_of(std::span<const Number> costs) {
  auto colours = std::make_shared<Colours>();
  colours->reserve(costs.size());
  for (const Number cost : costs) colours->push_back(heat_colour(cost / largest_heat));
  return colours;
}

ImU32 colour_at(double share) {
  const Rgb rgb = heat_colour(share);
  return IM_COL32(rgb[0], rgb[1], rgb[2], 255);
}

}  // namespace

Rgb heat_colour(double share) {
  const double at = std::clamp(share, 0.0, 1.0) * (stops.size() - 1);
  const auto low = std::min(static_cast<std::size_t>(at), stops.size() - 2);
  const double part = at - static_cast<double>(low);
  Rgb result;
  for (std::size_t k = 0; k < 3; ++k)
    result[k] = static_cast<std::uint8_t>(std::lround((1 - part) * stops[low][k] + part * stops[low + 1][k]));
  return result;
}

std::shared_ptr<const Colours> heat_colours(std::span<const double> costs) {
  return colours_of(costs);
}

std::shared_ptr<const Colours> heat_colours(std::span<const float> costs) {
  return colours_of(costs);
}

void draw_heat_legend(ImDrawList& draw, const Fonts& fonts, const Palette& palette, ImVec2 corner) {
  const float scale = fonts.scale;
  ImGui::PushFont(fonts.small);
  const float line = ImGui::GetTextLineHeight();
  const float width = 150 * scale;
  const float pad = 8 * scale;
  const ImVec2 high(corner.x - 8 * scale, corner.y - 8 * scale);
  const ImVec2 low(high.x - width - 2 * pad, high.y - 2 * line - 3 * pad - 4 * scale);
  const ImVec4& back = palette.panel;
  draw.AddRectFilled(low, high, ImGui::GetColorU32({back.x, back.y, back.z, 0.85F}), 4 * scale);
  const ImU32 text = ImGui::GetColorU32(palette.text);
  draw.AddText({low.x + pad, low.y + pad * 0.6F}, text, "How badly it is explained");
  const float bar_top = low.y + pad + line + 2 * scale;
  const float bar_bottom = bar_top + 8 * scale;
  constexpr int fields = 24;
  for (int i = 0; i < fields; ++i) {
    const float from = low.x + pad + width * static_cast<float>(i) / fields;
    const float to = low.x + pad + width * static_cast<float>(i + 1) / fields;
    const ImU32 left = colour_at(static_cast<double>(i) / fields);
    const ImU32 right = colour_at(static_cast<double>(i + 1) / fields);
    draw.AddRectFilledMultiColor({from, bar_top}, {to, bar_bottom}, left, right, right, left);
  }
  const float y = bar_bottom + 2 * scale;
  const char* most = "1 and more";
  draw.AddText({low.x + pad, y}, text, "0");
  draw.AddText({low.x + pad + width / 2 - ImGui::CalcTextSize("0.5").x / 2, y}, text, "0.5");
  draw.AddText({low.x + pad + width - ImGui::CalcTextSize(most).x, y}, text, most);
  ImGui::PopFont();
}

}  // namespace archetype
