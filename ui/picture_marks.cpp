#include "ui/picture_marks.h"

#include <algorithm>
#include <cmath>

namespace archetype {
namespace {

int part_of_mask(const Picture& mask, std::size_t pixel) {
  if (mask.pixels[4 * pixel + 3] == 0) return -1;
  return mask.pixels[4 * pixel] + 256 * mask.pixels[4 * pixel + 1] - 1;
}

}  // namespace

Rgb mask_colour(int part) {
  const int value = part + 1;
  return {static_cast<std::uint8_t>(value & 255), static_cast<std::uint8_t>(value >> 8), 0};
}

void highlight_part(Picture& picture, const Picture& mask, int part) {
  if (mask.width != picture.width || mask.height != picture.height) return;
  for (std::size_t i = 0; 4 * i < picture.pixels.size(); ++i) {
    if (part_of_mask(mask, i) == part) continue;
    std::uint8_t* const pixel = &picture.pixels[4 * i];
    const int light = (3 * pixel[0] + 6 * pixel[1] + pixel[2]) / 10;
    for (int k = 0; k < 3; ++k) pixel[k] = static_cast<std::uint8_t>((pixel[k] + 4 * light) / 5);
    pixel[3] = static_cast<std::uint8_t>(pixel[3] * 2 / 5);
  }
}

Rgb dimmed(const Rgb& colour) {
  Rgb result;
  for (std::size_t k = 0; k < result.size(); ++k)
    result[k] = static_cast<std::uint8_t>((colour[k] + 5 * 128) / 6);
  return result;
}

std::shared_ptr<const Colours> highlighted_colours(std::shared_ptr<const Colours> colours,
                                                   std::span<const std::int16_t> labels, int part) {
  if (!colours || colours->size() != labels.size()) return colours;
  auto result = std::make_shared<Colours>(*colours);
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i] != part) (*result)[i] = dimmed((*result)[i]);
  return result;
}

void draw_ring(Picture& picture, double x, double y) {
  constexpr double radius = 9;
  for (int row = 0; row < picture.height; ++row)
    for (int column = 0; column < picture.width; ++column) {
      const double away = std::abs(std::hypot(column + 0.5 - x, row + 0.5 - y) - radius);
      if (away > 3) continue;
      std::uint8_t* const pixel = &picture.pixels[4 * static_cast<std::size_t>(row * picture.width + column)];
      const Rgb colour = away < 1.7 ? Rgb{255, 196, 46} : Rgb{20, 22, 26};
      std::copy(colour.begin(), colour.end(), pixel);
      pixel[3] = 255;
    }
}

}  // namespace archetype
