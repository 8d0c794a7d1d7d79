// The window's fonts: Roboto with the icons of Font Awesome merged in, from Debian's packages.
#pragma once

#include <imgui.h>

#include <string>
#include <vector>

namespace archetype {

struct Fonts {
  ImFont* regular = nullptr;  // never null once loaded
  ImFont* bold = nullptr;
  ImFont* small = nullptr;
  ImFont* title = nullptr;
  float scale = 1;
  std::vector<std::string> missing;  // font files that are not there, so that Dear ImGui's own stands in
};

// Replaces the fonts of the current Dear ImGui context; the back end has to make its texture again. The files
// are those that were found when the program was configured, or else Debian's usual places.
Fonts load_fonts(float scale);

}  // namespace archetype
