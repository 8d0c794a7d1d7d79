// Text in pictures that no window draws: captions of figures, of any size.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "core/base/picture.h"
#include "core/model/part_colours.h"

namespace archetype {

// A TrueType font. Where its file is missing or broken nothing is written: a figure without captions is
// better than none.
class Lettering {
 public:
  explicit Lettering(const std::filesystem::path& font_file);
  Lettering(Lettering&&) noexcept;
  Lettering& operator=(Lettering&&) noexcept;
  ~Lettering();

  // Pixels; `size` is the height of a line.
  float width(const std::string& text, float size) const;
  // Draws UTF-8 with its upper left corner there; what lies outside of the picture is cut off.
  void draw(Picture& picture, const std::string& text, float left, float top, float size,
            const Rgb& colour) const;
  // The text cut to a width with "…" at its end.
  std::string fitted(const std::string& text, float width, float size) const;

 private:
  struct Font;
  std::unique_ptr<Font> font_;  // null: there is none
};

}  // namespace archetype
