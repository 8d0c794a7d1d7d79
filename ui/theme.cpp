#include "ui/theme.h"

namespace archetype {
namespace {

ImVec4 rgb(unsigned hex, float alpha = 1.0f) {
  return {static_cast<float>((hex >> 16) & 0xff) / 255.0f, static_cast<float>((hex >> 8) & 0xff) / 255.0f,
          static_cast<float>(hex & 0xff) / 255.0f, alpha};
}

const Palette dark{.back = rgb(0x16181c),
                   .panel = rgb(0x1e2126),
                   .raised = rgb(0x2a2e35),
                   .hovered = rgb(0x363c45),
                   .border = rgb(0x31363e),
                   .text = rgb(0xe4e7eb),
                   .muted = rgb(0x97a1ad),
                   .accent = rgb(0x4f9cf0),
                   .on_accent = rgb(0x0b1520),
                   .good = rgb(0x55c38a),
                   .warning = rgb(0xe8b04a),
                   .error = rgb(0xf0705f)};

const Palette light{.back = rgb(0xe4e7eb),
                    .panel = rgb(0xf7f8fa),
                    .raised = rgb(0xe6e9ee),
                    .hovered = rgb(0xd6dce4),
                    .border = rgb(0xd0d5dc),
                    .text = rgb(0x1d2329),
                    .muted = rgb(0x5b6672),
                    .accent = rgb(0x1f6fd0),
                    .on_accent = rgb(0xffffff),
                    .good = rgb(0x1f8a53),
                    .warning = rgb(0x9a6700),
                    .error = rgb(0xc03425)};

ImVec4 with_alpha(ImVec4 colour, float alpha) {
  colour.w = alpha;
  return colour;
}

}  // namespace

Theme parse_theme(std::string_view name) {
  return name == "light" ? Theme::light : Theme::dark;
}

const Palette& palette(Theme theme) {
  return theme == Theme::light ? light : dark;
}

ImVec4 severity_colour(const Palette& colours, Severity severity) {
  return severity == Severity::error     ? colours.error
         : severity == Severity::warning ? colours.warning
                                         : colours.muted;
}

void apply_theme(Theme theme, float scale) {
  const Palette& p = palette(theme);
  ImGuiStyle style;
  style.WindowPadding = {12, 10};
  style.FramePadding = {9, 5};
  style.CellPadding = {6, 4};
  style.ItemSpacing = {8, 7};
  style.ItemInnerSpacing = {6, 5};
  style.IndentSpacing = 16;
  style.ScrollbarSize = 12;
  style.GrabMinSize = 12;
  style.WindowRounding = 8;
  style.ChildRounding = 6;
  style.FrameRounding = 5;
  style.PopupRounding = 8;
  style.ScrollbarRounding = 6;
  style.GrabRounding = 5;
  style.TabRounding = 5;
  style.WindowBorderSize = 1;
  style.ChildBorderSize = 0;
  style.PopupBorderSize = 1;
  style.FrameBorderSize = 0;
  style.TabBorderSize = 0;
  style.WindowTitleAlign = {0.0f, 0.5f};
  style.WindowMenuButtonPosition = ImGuiDir_None;
  style.DisabledAlpha = 0.45f;
  style.ScaleAllSizes(scale);

  ImVec4* c = style.Colors;
  c[ImGuiCol_Text] = p.text;
  c[ImGuiCol_TextDisabled] = p.muted;
  c[ImGuiCol_WindowBg] = p.panel;
  c[ImGuiCol_ChildBg] = with_alpha(p.panel, 0);
  c[ImGuiCol_PopupBg] = p.panel;
  c[ImGuiCol_Border] = p.border;
  c[ImGuiCol_BorderShadow] = with_alpha(p.border, 0);
  c[ImGuiCol_FrameBg] = p.raised;
  c[ImGuiCol_FrameBgHovered] = p.hovered;
  c[ImGuiCol_FrameBgActive] = p.hovered;
  c[ImGuiCol_TitleBg] = c[ImGuiCol_TitleBgActive] = c[ImGuiCol_TitleBgCollapsed] = p.panel;
  c[ImGuiCol_MenuBarBg] = p.panel;
  c[ImGuiCol_ScrollbarBg] = with_alpha(p.panel, 0);
  c[ImGuiCol_ScrollbarGrab] = p.hovered;
  c[ImGuiCol_ScrollbarGrabHovered] = c[ImGuiCol_ScrollbarGrabActive] = p.muted;
  c[ImGuiCol_CheckMark] = p.accent;
  c[ImGuiCol_SliderGrab] = c[ImGuiCol_SliderGrabActive] = p.accent;
  c[ImGuiCol_Button] = p.raised;
  c[ImGuiCol_ButtonHovered] = p.hovered;
  c[ImGuiCol_ButtonActive] = with_alpha(p.accent, 0.5f);
  c[ImGuiCol_Header] = with_alpha(p.accent, 0.28f);
  c[ImGuiCol_HeaderHovered] = p.hovered;
  c[ImGuiCol_HeaderActive] = with_alpha(p.accent, 0.4f);
  c[ImGuiCol_Separator] = p.border;
  c[ImGuiCol_SeparatorHovered] = c[ImGuiCol_SeparatorActive] = p.accent;
  c[ImGuiCol_ResizeGrip] = with_alpha(p.accent, 0);
  c[ImGuiCol_ResizeGripHovered] = c[ImGuiCol_ResizeGripActive] = p.accent;
  c[ImGuiCol_Tab] = c[ImGuiCol_TabUnfocused] = p.panel;
  c[ImGuiCol_TabHovered] = p.hovered;
  c[ImGuiCol_TabActive] = c[ImGuiCol_TabUnfocusedActive] = p.raised;
  c[ImGuiCol_PlotLines] = c[ImGuiCol_PlotHistogram] = p.accent;
  c[ImGuiCol_PlotLinesHovered] = c[ImGuiCol_PlotHistogramHovered] = p.text;
  c[ImGuiCol_TableHeaderBg] = p.raised;
  c[ImGuiCol_TableBorderStrong] = c[ImGuiCol_TableBorderLight] = p.border;
  c[ImGuiCol_TableRowBg] = with_alpha(p.raised, 0);
  c[ImGuiCol_TableRowBgAlt] = with_alpha(p.raised, 0.35f);
  c[ImGuiCol_TextSelectedBg] = with_alpha(p.accent, 0.35f);
  c[ImGuiCol_NavHighlight] = p.accent;
  c[ImGuiCol_ModalWindowDimBg] = with_alpha(rgb(0), theme == Theme::light ? 0.25f : 0.5f);
  ImGui::GetStyle() = style;
}

}  // namespace archetype
