#include "ui/colour_legend.h"

#include <algorithm>

#include "ui/heat_map.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

constexpr float pad = 8;           // at scale 1
constexpr float most_width = 150;  // of a name, at scale 1

ImU32 opaque(const Rgb& rgb) {
  return IM_COL32(rgb[0], rgb[1], rgb[2], 255);
}

void fill_back(ImDrawList& draw, const Palette& palette, ImVec2 low, ImVec2 high, float scale) {
  const ImVec4& back = palette.panel;
  draw.AddRectFilled(low, high, ImGui::GetColorU32({back.x, back.y, back.z, 0.85F}), 4 * scale);
}

}  // namespace

void draw_colour_scale(ImDrawList& draw, const Fonts& fonts, const Palette& palette, ImVec2 corner,
                       const ColourScale& legend) {
  const float scale = fonts.scale;
  ImGui::PushFont(fonts.small);
  const float line = ImGui::GetTextLineHeight();
  const auto wide = [](const std::string& words) { return ImGui::CalcTextSize(words.c_str()).x; };
  // Wide enough that the middle number keeps off the last one.
  const float width =
      std::max({150 * scale, wide(legend.title), 2 * wide(legend.most) + wide(legend.middle) + 16 * scale});
  const float gap = pad * scale;
  const ImVec2 high(corner.x - 8 * scale, corner.y - 8 * scale);
  const ImVec2 low(high.x - width - 2 * gap, high.y - 2 * line - 3 * gap - 4 * scale);
  fill_back(draw, palette, low, high, scale);
  const ImU32 text = ImGui::GetColorU32(palette.text);
  draw.AddText({low.x + gap, low.y + gap * 0.6F}, text, legend.title.c_str());
  const float bar_top = low.y + gap + line + 2 * scale;
  const float bar_bottom = bar_top + 8 * scale;
  constexpr int fields = 24;
  for (int i = 0; i < fields; ++i) {
    const float from = low.x + gap + width * static_cast<float>(i) / fields;
    const float to = low.x + gap + width * static_cast<float>(i + 1) / fields;
    const ImU32 left = opaque(heat_colour(static_cast<double>(i) / fields));
    const ImU32 right = opaque(heat_colour(static_cast<double>(i + 1) / fields));
    draw.AddRectFilledMultiColor({from, bar_top}, {to, bar_bottom}, left, right, right, left);
  }
  const float y = bar_bottom + 2 * scale;
  draw.AddText({low.x + gap, y}, text, "0");
  const auto place = [&](const std::string& number, float share) {
    draw.AddText({low.x + gap + share * (width - wide(number)), y}, text, number.c_str());
  };
  place(legend.middle, 0.5F);
  place(legend.most, 1);
  ImGui::PopFont();
}

void draw_colour_names(ImDrawList& draw, const Fonts& fonts, const Palette& palette, ImVec2 corner,
                       float height, const std::vector<ColourName>& names) {
  if (names.empty()) return;
  const float scale = fonts.scale;
  ImGui::PushFont(fonts.small);
  const float line = ImGui::GetTextLineHeight() + 3 * scale;
  const float gap = pad * scale;
  const auto room = static_cast<std::size_t>(std::max(1.F, (height - 2 * gap) / line));
  std::vector<ColourName> shown = names;
  if (shown.size() > room) {
    shown.resize(room);
    shown.back() = {{128, 128, 128}, "and " + plural(names.size() - room + 1, "other")};
  }
  float width = 0;
  for (ColourName& name : shown) {
    name.name = fitted(name.name, most_width * scale);
    width = std::max(width, ImGui::CalcTextSize(name.name.c_str()).x);
  }
  const float swatch = 0.6F * ImGui::GetTextLineHeight();
  const ImVec2 high(corner.x - 8 * scale, corner.y - 8 * scale);
  const ImVec2 low(high.x - width - swatch - 3 * gap, high.y - line * static_cast<float>(shown.size()) - gap);
  fill_back(draw, palette, low, high, scale);
  float y = low.y + gap * 0.6F;
  for (const ColourName& name : shown) {
    const float top = y + 0.5F * (ImGui::GetTextLineHeight() - swatch);
    draw.AddRectFilled({low.x + gap, top}, {low.x + gap + swatch, top + swatch}, opaque(name.colour),
                       2 * scale);
    draw.AddText({low.x + 2 * gap + swatch, y}, ImGui::GetColorU32(palette.text), name.name.c_str());
    y += line;
  }
  ImGui::PopFont();
}

}  // namespace archetype
