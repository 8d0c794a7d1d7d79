// A picture in memory: thumbnails, screenshots, figures.
#pragma once

#include <cstdint>
#include <vector>

namespace archetype {

// RGBA, 8 bits a channel, not premultiplied, top row first; pixels.size() == 4 * width * height.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;
  friend bool operator==(const Picture&, const Picture&) = default;
};

}  // namespace archetype
