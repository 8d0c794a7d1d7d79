// Suggested templates as pictures, the best first: each fitted to the shape whose segmentation it comes from.
#include <imgui.h>

#include <algorithm>
#include <cstdio>

#include "ui/icons.h"
#include "ui/learning_actions.h"
#include "ui/panels.h"
#include "ui/studio.h"
#include "ui/template_picture.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

constexpr std::size_t columns = 5;

// True when it was double clicked.
bool draw_suggestion(Studio& studio, std::size_t rank, float side) {
  const Suggestion& suggestion = studio.ui.suggestions[rank];
  const PartTemplate& part_template = suggestion.found.part_template;
  ImGui::BeginGroup();
  ImGui::PushID(static_cast<int>(rank));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool chosen = studio.ui.chosen_suggestion == rank;
  const bool clicked =
      ImGui::Selectable("##take", chosen, ImGuiSelectableFlags_AllowDoubleClick, {side, side});
  mark_target(studio, "suggestion:" + std::to_string(rank + 1));
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  if (suggestion.source) {
    // The boxes small in a corner, so that both are seen.
    const float larger = side * 0.8f;
    draw_fit_picture(draw, suggestion.source->fit, suggestion.source->samples,
                     {at.x + side * 0.02f, at.y + side - larger}, larger);
    draw_template_picture(draw, part_template, {at.x + side * 0.68f, at.y + side * 0.02f}, side * 0.3f);
  } else {
    draw_template_picture(draw, part_template, at, side);
  }
  const ImU32 frame = ImGui::GetColorU32(chosen ? colours(studio).accent : colours(studio).border);
  draw.AddRect(at, {at.x + side, at.y + side}, frame, 4 * studio.fonts.scale, 0, chosen ? 2.0f : 1.0f);
  ImGui::PopID();
  char text[96];
  std::snprintf(text, sizeof text, "score %.3f, %zu parts", suggestion.found.score,
                part_template.parts.size());
  ImGui::TextUnformatted(fitted(part_template.name, side).c_str());
  tooltip(part_template.name.c_str());
  muted_text(studio, fitted(text, side));
  tooltip("How far it is from the shapes once it was estimated from them");
  ImGui::EndGroup();
  if (clicked) studio.ui.chosen_suggestion = rank;
  return clicked && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
}

// The arrows choose; true when Enter takes what is chosen.
bool follow_keys(Studio& studio) {
  if (!ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows)) return false;
  const auto tapped = [](ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetIO().KeyMap[key]); };
  std::size_t& chosen = studio.ui.chosen_suggestion;
  const std::size_t last = studio.ui.suggestions.size() - 1;
  if (tapped(ImGuiKey_RightArrow)) chosen = std::min(chosen + 1, last);
  if (tapped(ImGuiKey_LeftArrow) && chosen > 0) --chosen;
  if (tapped(ImGuiKey_DownArrow) && chosen + columns <= last) chosen += columns;
  if (tapped(ImGuiKey_UpArrow) && chosen >= columns) chosen -= columns;
  return tapped(ImGuiKey_Enter) || tapped(ImGuiKey_KeyPadEnter);
}

}  // namespace

void draw_suggestions_window(Studio& studio) {
  if (!studio.ui.show_suggestions || studio.ui.suggestions.empty()) return;
  const ImGuiViewport* screen = ImGui::GetMainViewport();
  const ImVec2 size(std::min(980 * studio.fonts.scale, screen->WorkSize.x * 0.94f),
                    std::min(620 * studio.fonts.scale, screen->WorkSize.y * 0.94f));
  ImGui::SetNextWindowPos(screen->GetWorkCenter(), ImGuiCond_Appearing, {0.5f, 0.5f});
  ImGui::SetNextWindowSize(size, ImGuiCond_Appearing);
  if (ImGui::Begin("Suggested templates", &studio.ui.show_suggestions, ImGuiWindowFlags_NoCollapse)) {
    if (ImGui::IsWindowAppearing()) ImGui::SetWindowFocus();
    muted_paragraph(
        studio,
        "The one whose boxes lie nearest to the shapes, once it was estimated from them, comes first. The "
        "points are those of the shape that it was made of, in the colours of the parts; some were cut into "
        "boxes, others into round parts as well. A double click or Enter takes one; learning makes it "
        "better.");
    std::size_t& chosen = studio.ui.chosen_suggestion;
    chosen = std::min(chosen, studio.ui.suggestions.size() - 1);
    std::optional<std::size_t> taken;
    if (follow_keys(studio)) taken = chosen;
    if (ImGui::Button((std::string(icon::check) + "  Take the chosen one").c_str())) taken = chosen;
    mark_target(studio, "suggestions:take");
    ImGui::BeginChild("##candidates");
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float side = (ImGui::GetContentRegionAvail().x - (columns - 1) * gap) / columns;
    for (std::size_t rank = 0; rank < studio.ui.suggestions.size(); ++rank) {
      if (rank % columns != 0) ImGui::SameLine();
      if (draw_suggestion(studio, rank, side)) taken = rank;
    }
    ImGui::EndChild();
    if (taken) {
      take_suggestion(studio, *taken);
      studio.ui.show_suggestions = false;
    }
  }
  ImGui::End();
}

}  // namespace archetype
