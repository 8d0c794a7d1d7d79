// The colours of parts: the same in exports, viewports, thumbnails and legends.
#pragma once

#include <array>
#include <cstdint>

namespace archetype {

struct PartTemplate;

using Rgb = std::array<std::uint8_t, 3>;  // sRGB

inline constexpr int part_colour_count = 21;  // distinct ones; they repeat from there

// The colour of a part by its index; any negative index (null_label) is a neutral grey that no part has.
// Seven hues that colour-blind readers can tell apart (Okabe and Ito 2008), then the same darker, then
// lighter.
Rgb part_colour(int part);

// The same for a part of a template, which may have been given another colour of these by hand.
Rgb part_colour(const PartTemplate& part_template, int part);

}  // namespace archetype
