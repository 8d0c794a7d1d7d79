// Up axes.
#include "core/geometry/shape_frame.h"

#include <array>

namespace archetype {

namespace {
constexpr std::array<std::string_view, 6> names{"y", "z", "x", "-y", "-z", "-x"};
}

std::string_view to_string(UpAxis up) {
  return names[static_cast<std::size_t>(up)];
}

std::optional<UpAxis> parse_up_axis(std::string_view text) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (text == names[i]) return static_cast<UpAxis>(i);
  }
  return std::nullopt;
}

Mat3 upright_rotation(UpAxis up) {
  Mat3 m;
  switch (up) {
    case UpAxis::y:
      m << 1, 0, 0, 0, 1, 0, 0, 0, 1;
      break;
    case UpAxis::z:
      m << 1, 0, 0, 0, 0, 1, 0, -1, 0;
      break;
    case UpAxis::x:
      m << 0, -1, 0, 1, 0, 0, 0, 0, 1;
      break;
    case UpAxis::minus_y:
      m << 1, 0, 0, 0, -1, 0, 0, 0, -1;
      break;
    case UpAxis::minus_z:
      m << 1, 0, 0, 0, 0, -1, 0, 1, 0;
      break;
    case UpAxis::minus_x:
      m << 0, 1, 0, -1, 0, 0, 0, 0, 1;
      break;
  }
  return m;
}

}  // namespace archetype
