// The one place that knows stb_truetype.
#include "render/lettering.h"

#include <stb/stb_truetype.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <vector>

#include "render/large_picture.h"

namespace archetype {

struct Lettering::Font {
  std::vector<unsigned char> file;
  stbtt_fontinfo info{};
  float ascent = 0;  // shares of the line's height
  float scale_of(float size) const { return stbtt_ScaleForPixelHeight(&info, size); }
};

namespace {

// The next character of UTF-8; what is no UTF-8 gives U+FFFD, byte by byte.
int next_letter(const std::string& text, std::size_t& at) {
  const auto lead = static_cast<unsigned char>(text[at++]);
  if (lead < 0x80) return lead;
  const int more = lead >= 0xf0 && lead < 0xf8 ? 3 : lead >= 0xe0 ? 2 : lead >= 0xc2 ? 1 : 0;
  if (more == 0 || lead >= 0xf8 || at + static_cast<std::size_t>(more) > text.size()) return 0xfffd;
  int letter = lead & (0x3f >> more);
  for (int i = 0; i < more; ++i) {
    const auto byte = static_cast<unsigned char>(text[at + static_cast<std::size_t>(i)]);
    if ((byte & 0xc0) != 0x80) return 0xfffd;
    letter = letter << 6 | (byte & 0x3f);
  }
  at += static_cast<std::size_t>(more);
  return letter;
}

float advance_of(const stbtt_fontinfo& info, int glyph, float scale) {
  int advance = 0;
  stbtt_GetGlyphHMetrics(&info, glyph, &advance, nullptr);
  return scale * static_cast<float>(advance);
}

}  // namespace

Lettering::Lettering(const std::filesystem::path& font_file) {
  std::ifstream file(font_file, std::ios::binary);
  auto font = std::make_unique<Font>();
  font->file.assign(std::istreambuf_iterator<char>(file), {});
  if (font->file.size() < 1000) return;
  const int offset = stbtt_GetFontOffsetForIndex(font->file.data(), 0);
  if (offset < 0 || stbtt_InitFont(&font->info, font->file.data(), offset) == 0) return;
  int ascent = 0;
  int descent = 0;
  stbtt_GetFontVMetrics(&font->info, &ascent, &descent, nullptr);
  font->ascent = static_cast<float>(ascent) / static_cast<float>(std::max(ascent - descent, 1));
  font_ = std::move(font);
}

Lettering::Lettering(Lettering&&) noexcept = default;
Lettering& Lettering::operator=(Lettering&&) noexcept = default;
Lettering::~Lettering() = default;

float Lettering::width(const std::string& text, float size) const {
  if (!font_) return 0;
  float sum = 0;
  for (std::size_t at = 0; at < text.size();)
    sum += advance_of(font_->info, stbtt_FindGlyphIndex(&font_->info, next_letter(text, at)),
                      font_->scale_of(size));
  return sum;
}

void Lettering::draw(Picture& picture, const std::string& text, float left, float top, float size,
                     const Rgb& colour) const {
  if (!font_) return;
  const float scale = font_->scale_of(size);
  const float base = std::round(top + font_->ascent * size);
  std::vector<unsigned char> coverage;
  for (std::size_t at = 0; at < text.size();) {
    const int glyph = stbtt_FindGlyphIndex(&font_->info, next_letter(text, at));
    const float whole = std::floor(left);
    int x0 = 0;
    int y0 = 0;
    int x1 = 0;
    int y1 = 0;
    stbtt_GetGlyphBitmapBoxSubpixel(&font_->info, glyph, scale, scale, left - whole, 0, &x0, &y0, &x1, &y1);
    const int wide = x1 - x0;
    const int high = y1 - y0;
    if (wide > 0 && high > 0) {
      coverage.assign(static_cast<std::size_t>(wide) * static_cast<std::size_t>(high), 0);
      stbtt_MakeGlyphBitmapSubpixel(&font_->info, coverage.data(), wide, high, wide, scale, scale,
                                    left - whole, 0, glyph);
      Picture letter{wide, high, {}};
      for (const unsigned char opacity : coverage)
        letter.pixels.insert(letter.pixels.end(), {colour[0], colour[1], colour[2], opacity});
      lay_over(picture, letter, static_cast<int>(whole) + x0, static_cast<int>(base) + y0);
    }
    left += advance_of(font_->info, glyph, scale);
  }
}

std::string Lettering::fitted(const std::string& text, float most, float size) const {
  if (width(text, size) <= most) return text;
  std::string cut = text;
  while (!cut.empty()) {
    do cut.pop_back();
    while (!cut.empty() && (static_cast<unsigned char>(cut.back()) & 0xc0) == 0x80);
    if (width(cut + "…", size) <= most) return cut + "…";
  }
  return "";
}

}  // namespace archetype
