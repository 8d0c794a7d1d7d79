// What stands above the clusters.
#include <imgui.h>

#include <algorithm>

#include "ui/clusters_view.h"
#include "ui/filter_panel.h"
#include "ui/icons.h"
#include "ui/order_menu.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {

void draw_clusters_tools(Studio& studio) {
  const float scale = studio.fonts.scale;
  draw_order_button(studio, "clusters:order", 150 * scale);
  ImGui::SameLine();
  draw_filter_button(studio, ImGui::GetFrameHeight());
  separator_in_line(studio);
  command_toggle(studio, "cluster-spread", "Spread");
  ImGui::SameLine();
  command_toggle(studio, "expand-clusters", "All members");
  ImGui::SameLine();
  command_button(studio, "family-tree", std::string(icon::tree) + "  Family tree");
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  muted_text(studio, icon::grid);
  ImGui::SameLine(0, 4 * scale);
  float size = static_cast<float>(studio.ui.clusters.cell_size);
  ImGui::SetNextItemWidth(90 * scale);
  if (ImGui::SliderFloat("##size", &size, static_cast<float>(least_cluster_cell),
                         static_cast<float>(most_cluster_cell), ""))
    studio.ui.clusters.cell_size =
        std::clamp(static_cast<double>(size), least_cluster_cell, most_cluster_cell);
  mark_target(studio, "clusters:size");
  tooltip("Size of the pictures (Ctrl and the wheel)");
  const auto& clusters = follow_clusters(studio);
  const auto templates =
      static_cast<std::size_t>(std::ranges::count(clusters, ClusterKind::members, &ShapeCluster::kind));
  const std::string text = plural(templates, "template") + ", " + count_text(shown_rows(studio).size()) +
                           " of " + count_text(studio.collection.rows().size()) + " shapes";
  const float room = ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(text.c_str()).x;
  ImGui::SameLine();
  if (room < ImGui::GetCursorPosX() + 8 * scale) return;
  ImGui::SetCursorPosX(room);
  ImGui::AlignTextToFramePadding();
  muted_text(studio, text);
}

}  // namespace archetype
