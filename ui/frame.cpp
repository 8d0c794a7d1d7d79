// The layout: the collection on the left, the shape in the middle, the template and the fit on the right,
// jobs and messages below. Dear ImGui 1.86 has no docking: the panels are windows that stand still, with bars
// between them that can be dragged.
#include "ui/frame.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>

#include "ui/centre_views.h"
#include "ui/file_browser.h"
#include "ui/filter_panel.h"
#include "ui/inspect_panels.h"
#include "ui/panels.h"
#include "ui/recovery.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

struct Rect {
  ImVec2 low;
  ImVec2 high;
  ImVec2 size() const { return {high.x - low.x, high.y - low.y}; }
};

struct Layout {
  Rect left, tools, centre, right, bottom, status;
  float gap = 0;
};

// At scale 1. Only while the tab is shown: the views above need the room at other times.
double least_height(BottomTab tab) {
  return tab == BottomTab::learning ? 300 : tab == BottomTab::filter ? 220 : 60;
}

// Widths as the user set them, but never so wide that the view in the middle gets lost.
Layout lay_out(const Studio& studio) {
  const ImGuiViewport* screen = ImGui::GetMainViewport();
  const float scale = studio.fonts.scale;
  const Settings& settings = studio.settings;
  const ImVec2 low = screen->WorkPos;
  const ImVec2 high(low.x + screen->WorkSize.x, low.y + screen->WorkSize.y);
  Layout layout;
  layout.gap = 5 * scale;
  const float status = ImGui::GetTextLineHeight() + 10 * scale;
  const float tools = ImGui::GetFrameHeight() + 10 * scale;
  const float width = high.x - low.x;
  const float side_share = width * 0.32f;
  const float left = std::min(static_cast<float>(settings.left_width) * scale, side_share);
  const float right = std::min(static_cast<float>(settings.right_width) * scale, side_share);
  const double wanted = std::max(settings.bottom_height, least_height(studio.ui.bottom_tab));
  const float below =
      settings.show_bottom ? std::min(static_cast<float>(wanted) * scale, (high.y - low.y) * 0.5f) : 0.0f;
  const float main_high = high.y - status;
  const float centre_high = settings.show_bottom ? main_high - below - layout.gap : main_high;
  const float x0 = low.x + left + layout.gap;
  const float x1 = high.x - right - layout.gap;
  layout.left = {low, {low.x + left, centre_high}};
  layout.tools = {{x0, low.y}, {x1, low.y + tools}};
  layout.centre = {{x0, low.y + tools}, {x1, centre_high}};
  layout.right = {{x1 + layout.gap, low.y}, {high.x, main_high}};
  layout.bottom = {{low.x, centre_high + layout.gap}, {x1, main_high}};
  layout.status = {{low.x, main_high}, high};
  return layout;
}

// The panels' colour is what the picture is cleared to (imgui_session.cpp): filling every panel once more
// would be a third of the time that a frame takes without a graphics card.
constexpr ImGuiWindowFlags still = ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoDecoration |
                                   ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                                   ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNavFocus;

void begin_area(const char* name, const Rect& rect, ImGuiWindowFlags flags = 0) {
  ImGui::SetNextWindowPos(rect.low);
  ImGui::SetNextWindowSize(rect.size());
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
  ImGui::Begin(name, nullptr,
               (still & ~(flags & ImGuiWindowFlags_NoScrollbar ? 0 : ImGuiWindowFlags_NoScrollbar)) | flags);
  ImGui::PopStyleVar(3);
}

// A bar between two panels; `value` (at scale 1) follows the mouse in the direction of `sign`.
void splitter(Studio& studio, const char* name, const Rect& rect, bool vertical, double& value, double sign,
              double least, double most) {
  ImGui::SetCursorScreenPos(rect.low);
  ImGui::InvisibleButton(name, rect.size());
  mark_target(studio, std::string("splitter:") + name);
  if (ImGui::IsItemHovered() || ImGui::IsItemActive()) {
    ImGui::SetMouseCursor(vertical ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
    const ImVec4 accent = colours(studio).accent;
    ImGui::GetWindowDrawList()->AddRectFilled(rect.low, rect.high, ImGui::GetColorU32(accent));
  }
  if (!ImGui::IsItemActive()) return;
  const ImVec2 moved = ImGui::GetIO().MouseDelta;
  value = std::clamp(value + sign * (vertical ? moved.x : moved.y) / studio.fonts.scale, least, most);
}

// Behind everything: the gaps between the panels.
void draw_background(Studio& studio, const Layout& layout) {
  const ImGuiViewport* screen = ImGui::GetMainViewport();
  begin_area(
      "##back",
      {screen->WorkPos, {screen->WorkPos.x + screen->WorkSize.x, screen->WorkPos.y + screen->WorkSize.y}},
      ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::BringWindowToDisplayBack(ImGui::GetCurrentWindow());
  const Layout& l = layout;
  const ImU32 gap = ImGui::GetColorU32(colours(studio).back);
  const auto fill = [&](ImVec2 low, ImVec2 high) {
    ImGui::GetWindowDrawList()->AddRectFilled(low, high, gap);
  };
  fill({l.left.high.x, l.left.low.y}, {l.tools.low.x, l.left.high.y});
  fill({l.tools.high.x, l.tools.low.y}, {l.right.low.x, l.right.high.y});
  if (studio.settings.show_bottom)
    fill({l.left.low.x, l.left.high.y}, {l.tools.high.x, l.left.high.y + l.gap});
  splitter(studio, "left", {{l.left.high.x, l.left.low.y}, {l.tools.low.x, l.left.high.y}}, true,
           studio.settings.left_width, 1, 120, 900);
  splitter(studio, "right", {{l.tools.high.x, l.right.low.y}, {l.right.low.x, l.right.high.y}}, true,
           studio.settings.right_width, -1, 200, 900);
  if (studio.settings.show_bottom)
    splitter(studio, "bottom", {{l.bottom.low.x, l.bottom.low.y - l.gap}, {l.bottom.high.x, l.bottom.low.y}},
             false, studio.settings.bottom_height, -1, least_height(studio.ui.bottom_tab), 900);
  ImGui::End();
}

void draw_bottom(Studio& studio) {
  if (!ImGui::BeginTabBar("bottom")) return;
  struct Tab {
    BottomTab tab;
    const char* name;
    void (*draw)(Studio&);
  };
  const std::array tabs{Tab{BottomTab::jobs, "Jobs", draw_jobs_panel},
                        Tab{BottomTab::filter, "Filter", draw_filter_panel},
                        Tab{BottomTab::strip, "Other shapes", draw_strip_panel},
                        Tab{BottomTab::learning, "Learning", draw_learning_panel},
                        Tab{BottomTab::messages, "Messages", draw_messages_panel},
                        Tab{BottomTab::history, "History", draw_history_panel},
                        Tab{BottomTab::diagnostics, "Diagnostics", draw_diagnostics_panel}};
  const std::optional<BottomTab> wanted = std::exchange(studio.ui.wanted_bottom_tab, std::nullopt);
  for (const Tab& tab : tabs) {
    const ImGuiTabItemFlags flags = wanted == tab.tab ? ImGuiTabItemFlags_SetSelected : 0;
    const bool shown = ImGui::BeginTabItem(tab.name, nullptr, flags);
    mark_target(studio, std::string("tab:") + tab.name);
    if (!shown) continue;
    studio.ui.bottom_tab = tab.tab;
    ImGui::BeginChild(tab.name, {0, 0});
    tab.draw(studio);
    ImGui::EndChild();
    ImGui::EndTabItem();
  }
  ImGui::EndTabBar();
}

void draw_inspector(Studio& studio) {
  if (const auto side = centre_view(studio).side) {
    side(studio);
    return;
  }
  draw_template_panel(studio);
  draw_compare_panel(studio);
  draw_part_panel(studio);
  draw_fit_panel(studio);
}

// What stands over the panels: while one is open, they tell nothing of what the mouse happens to rest on,
// which would be drawn over it.
bool stands_over_panels(const Studio& studio) {
  const UiState& ui = studio.ui;
  return ui.browser.open || ui.show_suggestions || ui.help || ui.about || ui.palette.open ||
         offers_recovery(studio) || asks_to_close(studio);
}

// Of the panels drawn so far in this frame, as Dear ImGui itself hides one tooltip for the next.
void hide_tooltips() {
  for (ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
    if (!(window->Flags & ImGuiWindowFlags_Tooltip) || !window->Active) continue;
    window->Hidden = true;
    window->HiddenFramesCanSkipItems = 1;
  }
  ++ImGui::GetCurrentContext()->TooltipOverrideCount;  // that of a window above is another one
}

// Esc while a number is dragged: Dear ImGui has to let go of it too, or the next movement would drag on.
void let_go(Studio& studio) {
  if (std::exchange(studio.ui.cancel_drag, false)) ImGui::ClearActiveID();
}

}  // namespace

void draw_frame(Studio& studio) {
  studio.targets.clear();
  let_go(studio);
  draw_menu_bar(studio);
  const Layout layout = lay_out(studio);
  draw_background(studio, layout);

  begin_area("##collection", layout.left, ImGuiWindowFlags_NoScrollbar);
  draw_collection_panel(studio);
  ImGui::End();

  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {8 * studio.fonts.scale, 5 * studio.fonts.scale});
  begin_area("##tools", layout.tools, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {2 * studio.fonts.scale, 7 * studio.fonts.scale});
  centre_view(studio).tools(studio);
  ImGui::PopStyleVar();
  ImGui::End();
  ImGui::PopStyleVar();

  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  begin_area("##viewport", layout.centre, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar();
  centre_view(studio).draw(studio);
  ImGui::End();

  begin_area("##inspector", layout.right);
  draw_inspector(studio);
  ImGui::End();

  if (studio.settings.show_bottom) {
    begin_area("##bottom", layout.bottom, ImGuiWindowFlags_NoScrollbar);
    draw_bottom(studio);
    ImGui::End();
  }

  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {12 * studio.fonts.scale, 5 * studio.fonts.scale});
  begin_area("##status", layout.status, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  draw_status_bar(studio);
  ImGui::End();
  ImGui::PopStyleVar();

  if (stands_over_panels(studio)) hide_tooltips();
  draw_file_browser(studio);
  draw_suggestions_window(studio);
  draw_help_window(studio);
  draw_about_window(studio);
  draw_command_palette(studio);
  draw_recovery_window(studio);
  draw_closing_window(studio);
}

std::span<const Panel> all_panels() {
  static constexpr std::array panels{Panel{"collection", draw_collection_panel},
                                     Panel{"template", draw_template_panel},
                                     Panel{"part", draw_part_panel},
                                     Panel{"fit", draw_fit_panel},
                                     Panel{"strip", draw_strip_panel},
                                     Panel{"filter", draw_filter_panel},
                                     Panel{"jobs", draw_jobs_panel},
                                     Panel{"learning", draw_learning_panel},
                                     Panel{"messages", draw_messages_panel},
                                     Panel{"history", draw_history_panel},
                                     Panel{"diagnostics", draw_diagnostics_panel},
                                     Panel{"corrections", draw_corrections_panel},
                                     Panel{"fit terms", draw_fit_terms_panel},
                                     Panel{"inspected fit", draw_inspect_view},
                                     Panel{"inspection tools", draw_inspect_tools},
                                     Panel{"tools", draw_tool_bar},
                                     Panel{"status", draw_status_bar}};
  return panels;
}

}  // namespace archetype
