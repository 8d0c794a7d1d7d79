#include "ui/heat_map.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/colour_legend.h"

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
  draw_colour_scale(draw, fonts, palette, corner, {"How badly it is explained", "0.5", "1 and more"});
}

}  // namespace archetype
