#include "ui/fonts.h"

#include <imgui_freetype.h>

#include <cmath>
#include <filesystem>

namespace archetype {
namespace {

ImFont* add_font(Fonts& fonts, const char* file, float size) {
  ImGuiIO& io = ImGui::GetIO();
  ImFont* font = nullptr;
  const float pixels = std::round(size * fonts.scale);
  if (std::filesystem::exists(file)) {
    ImFontConfig config;
    config.OversampleH = config.OversampleV = 1;  // FreeType hints to whole pixels: sharper than oversampling
    // What Roboto has of Latin, Greek and Cyrillic, for names of shapes, and punctuation. As below, Dear
    // ImGui keeps the pointer.
    static constexpr ImWchar letters[] = {0x20,   0x17f,  0x370,  0x3ff,  0x400,  0x52f,  0x1e00, 0x1eff,
                                          0x2010, 0x2044, 0x20ac, 0x20ac, 0x2212, 0x2212, 0};
    font = io.Fonts->AddFontFromFileTTF(file, pixels, &config, letters);
  } else {
    fonts.missing.emplace_back(file);
    ImFontConfig config;
    config.SizePixels = pixels;
    font = io.Fonts->AddFontDefault(&config);
  }
  if (std::filesystem::exists(ARCHETYPE_ICON_FONT)) {
    // Dear ImGui keeps the pointer until the atlas is built.
    static constexpr ImWchar icons[] = {0xf000, 0xf2e0, 0};
    ImFontConfig config;
    config.MergeMode = true;
    config.OversampleH = config.OversampleV = 1;
    config.GlyphMinAdvanceX = pixels * 1.1f;  // icons of one width, so that labels line up
    config.GlyphOffset.y = std::round(pixels * 0.06f);
    io.Fonts->AddFontFromFileTTF(ARCHETYPE_ICON_FONT, pixels * 0.95f, &config, icons);
  }
  return font;
}

}  // namespace

Fonts load_fonts(float scale) {
  ImGuiIO& io = ImGui::GetIO();
  io.Fonts->Clear();
  io.Fonts->FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
  io.Fonts->FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
  Fonts fonts;
  fonts.scale = scale;
  fonts.regular = add_font(fonts, ARCHETYPE_FONT_REGULAR, 15);
  fonts.bold = add_font(fonts, ARCHETYPE_FONT_BOLD, 15);
  fonts.small = add_font(fonts, ARCHETYPE_FONT_REGULAR, 13);
  fonts.title = add_font(fonts, ARCHETYPE_FONT_BOLD, 20);
  io.Fonts->Build();
  return fonts;
}

}  // namespace archetype
