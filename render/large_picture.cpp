// Draws piece by piece.
#include "render/large_picture.h"

#include <algorithm>

#include "render/splat.h"

namespace archetype {
namespace {

constexpr int piece_side = 1024;  // pixels
// A splat whose middle is outside of the piece is not drawn at all: pieces overlap by the largest.
int overlap_of_pieces(const PictureSize& size) {
  return static_cast<int>(size.line_scale * largest_splat_diameter) / 2 + 1;
}

void copy_into(Picture& whole, const Picture& piece, int overlap, int left, int top, int width, int height) {
  for (int y = 0; y < height; ++y) {
    const auto from = 4 * (static_cast<std::size_t>(y + overlap) * static_cast<std::size_t>(piece.width) +
                           static_cast<std::size_t>(overlap));
    const auto to = 4 * (static_cast<std::size_t>(top + y) * static_cast<std::size_t>(whole.width) +
                         static_cast<std::size_t>(left));
    std::copy_n(piece.pixels.begin() + static_cast<std::ptrdiff_t>(from), 4 * width,
                whole.pixels.begin() + static_cast<std::ptrdiff_t>(to));
  }
}

std::uint8_t mixed(std::uint8_t below, std::uint8_t above, int opacity) {
  return static_cast<std::uint8_t>((below * (255 - opacity) + above * opacity + 127) / 255);
}

}  // namespace

std::optional<Picture> draw_large_picture(Renderer& renderer, Scene scene, const Camera& camera,
                                          const PictureSize& size, const JobControl& control) {
  const bool white = scene.backdrop != Backdrop::transparent;
  scene.backdrop = Backdrop::transparent;
  Picture whole{size.width, size.height, {}};
  whole.pixels.resize(4 * static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
  RenderTarget target;
  const int overlap = overlap_of_pieces(size);
  for (int top = 0; top < size.height; top += piece_side)
    for (int left = 0; left < size.width; left += piece_side) {
      if (control.cancelled()) return std::nullopt;
      const int width = std::min(piece_side, size.width - left);
      const int height = std::min(piece_side, size.height - top);
      PictureSize piece = size;
      piece.width = std::min(piece_side, size.width) + 2 * overlap;
      piece.height = std::min(piece_side, size.height) + 2 * overlap;
      piece.piece = {size.width, size.height, left - overlap, top - overlap};
      renderer.draw(scene, camera, piece, target);
      copy_into(whole, target.read(), overlap, left, top, width, height);
    }
  if (!white) return whole;
  Picture page{size.width, size.height, std::vector<std::uint8_t>(whole.pixels.size(), 255)};
  lay_over(page, whole, 0, 0);
  return page;
}

void lay_over(Picture& below, const Picture& above, int left, int top) {
  for (int y = std::max(0, -top); y < above.height && top + y < below.height; ++y)
    for (int x = std::max(0, -left); x < above.width && left + x < below.width; ++x) {
      const auto from = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(above.width) +
                             static_cast<std::size_t>(x));
      const auto to = 4 * (static_cast<std::size_t>(top + y) * static_cast<std::size_t>(below.width) +
                           static_cast<std::size_t>(left + x));
      const int alpha = above.pixels[from + 3];
      if (alpha == 0) continue;
      const int under = below.pixels[to + 3];
      const int sum = alpha + (under * (255 - alpha) + 127) / 255;
      const int share = (alpha * 255 + sum / 2) / sum;  // of the upper colour in what is seen
      for (std::size_t k = 0; k < 3; ++k)
        below.pixels[to + k] = mixed(below.pixels[to + k], above.pixels[from + k], share);
      below.pixels[to + 3] = static_cast<std::uint8_t>(sum);
    }
}

}  // namespace archetype
