// The table of part colours: Okabe and Ito, "Color Universal Design", without its black, which outlines use.
#include "core/model/part_colours.h"

#include "core/model/part_template.h"

namespace archetype {

namespace {

constexpr std::array<Rgb, 7> hues{{
    {0, 114, 178},    // blue
    {230, 159, 0},    // orange
    {0, 158, 115},    // bluish green
    {204, 121, 167},  // reddish purple
    {86, 180, 233},   // sky blue
    {213, 94, 0},     // vermilion
    {240, 228, 66},   // yellow
}};
constexpr Rgb neutral{153, 153, 153};

// Moves a colour towards black (0) or white (255), in percent of the way.
constexpr Rgb mixed(const Rgb& colour, int with, int percent) {
  Rgb result{};
  for (std::size_t c = 0; c < colour.size(); ++c) {
    result[c] = static_cast<std::uint8_t>((colour[c] * (100 - percent) + with * percent) / 100);
  }
  return result;
}

}  // namespace

Rgb part_colour(int part) {
  if (part < 0) return neutral;
  const Rgb& hue = hues[static_cast<std::size_t>(part) % hues.size()];
  switch (part / static_cast<int>(hues.size()) % 3) {
    case 1:
      return mixed(hue, 0, 45);
    case 2:
      return mixed(hue, 255, 55);
    default:
      return hue;
  }
}

Rgb part_colour(const PartTemplate& part_template, int part) {
  if (part < 0 || static_cast<std::size_t>(part) >= part_template.parts.size()) return part_colour(part);
  const int own = part_template.parts[static_cast<std::size_t>(part)].colour;
  return part_colour(own >= 0 ? own : part);
}

}  // namespace archetype
