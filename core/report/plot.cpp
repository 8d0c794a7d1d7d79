#include "core/report/plot.h"

namespace archetype {
namespace {

// Paul Tol's "bright" and "vibrant" schemes, https://personal.sron.nl/~pault/.
constexpr std::array<Rgb, 8> hues{{{68, 119, 170},
                                   {238, 102, 119},
                                   {34, 136, 51},
                                   {204, 187, 68},
                                   {102, 204, 238},
                                   {170, 51, 119},
                                   {238, 119, 51},
                                   {120, 120, 120}}};

}  // namespace

Rgb series_colour(std::size_t index) {
  return hues[index % hues.size()];
}

}  // namespace archetype
