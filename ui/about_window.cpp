// What this program is, and who made the shapes that it came with.
#include <imgui.h>

#include <algorithm>

#include "ui/panels.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {

void draw_about_window(Studio& studio) {
  if (!studio.ui.about) return;
  const ImGuiViewport* screen = ImGui::GetMainViewport();
  const ImVec2 size(std::min(720 * studio.fonts.scale, screen->WorkSize.x * 0.9f),
                    std::min(560 * studio.fonts.scale, screen->WorkSize.y * 0.85f));
  ImGui::SetNextWindowPos(screen->GetWorkCenter(), ImGuiCond_Appearing, {0.5f, 0.5f});
  ImGui::SetNextWindowSize(size, ImGuiCond_Appearing);
  if (ImGui::Begin("About", &studio.ui.about, ImGuiWindowFlags_NoCollapse)) {
    ImGui::PushFont(studio.fonts.title);
    ImGui::TextUnformatted("Archetype " ARCHETYPE_VERSION);
    ImGui::PopFont();
    muted_paragraph(
        studio,
        "Learns what a class of shapes is made of: part-based templates from large collections, after Kim, "
        "Li, Mitra, Chaudhuri, DiVerdi and Funkhouser, SIGGRAPH 2013.");
    section_title(studio, "The shapes of this collection");
    if (studio.credits.empty()) {
      muted_paragraph(studio, "No makers are known for the shapes that are open.");
    } else if (ImGui::BeginTable("credits", 4, ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY)) {
      ImGui::TableSetupScrollFreeze(0, 1);
      for (const char* column : {"Shape", "Made by", "Catalogue", "Licence"}) ImGui::TableSetupColumn(column);
      ImGui::TableHeadersRow();
      for (const Credit& credit : studio.credits) {
        ImGui::TableNextRow();
        for (const std::string* text : {&credit.shape, &credit.creator, &credit.source, &credit.licence}) {
          ImGui::TableNextColumn();
          ImGui::TextWrapped("%s", text->c_str());
        }
      }
      ImGui::EndTable();
    }
  }
  ImGui::End();
}

}  // namespace archetype
