// The line above the clouds: which points, how they are coloured, rigid beside deformed or between the two.
#include <imgui.h>

#include <algorithm>
#include <map>

#include "core/session/cluster_size.h"
#include "ui/panels.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

struct Choice {
  CloudScope scope;
  TemplateId cluster;
  std::string name;
};

std::vector<Choice> choices(Studio& studio) {
  std::map<TemplateId, ClusterSize> members;
  for (const ShapeRow& row : studio.collection.rows())
    if (row.fit) members[row.fit->part_template].add(row.fit->status);
  std::vector<Choice> all{{CloudScope::collection, 0, "Whole collection"}};
  if (const auto table = use_fit_table(studio))
    for (const TemplateRecord& record : table->templates)
      if (const ClusterSize size = members[record.id]; size != ClusterSize{})
        all.push_back(
            {CloudScope::cluster, record.id, record.part_template.name + " (" + to_string(size) + ")"});
  all.push_back(
      {CloudScope::selection, 0, "Selected shapes (" + count_text(studio.ui.selection.shapes.size()) + ")"});
  return all;
}

bool is_chosen(const CloudChoice& cloud, const Choice& choice) {
  return cloud.scope == choice.scope &&
         (choice.scope != CloudScope::cluster || cloud.cluster == choice.cluster);
}

void draw_scope(Studio& studio) {
  CloudChoice& cloud = studio.ui.cloud;
  const std::vector<Choice> all = choices(studio);
  const auto chosen = std::ranges::find_if(all, [&](const Choice& c) { return is_chosen(cloud, c); });
  ImGui::SetNextItemWidth(190 * studio.fonts.scale);
  const bool open = ImGui::BeginCombo("##scope", chosen == all.end() ? "One cluster" : chosen->name.c_str());
  mark_target(studio, "cloud:scope");
  if (!open) return;
  for (const Choice& choice : all) {
    ImGui::PushID(&choice);
    if (ImGui::Selectable(choice.name.c_str(), is_chosen(cloud, choice))) {
      cloud.scope = choice.scope;
      cloud.cluster = choice.cluster;
    }
    mark_target(studio, "cloud:scope:" + choice.name);
    ImGui::PopID();
  }
  ImGui::EndCombo();
}

}  // namespace

void draw_cloud_tools(Studio& studio) {
  draw_scope(studio);
  separator_in_line(studio);
  ImGui::SameLine(0, 18 * studio.fonts.scale);  // a text has no frame that keeps it off the line
  muted_text(studio, "Colour by");
  ImGui::SameLine(0, 6 * studio.fonts.scale);
  command_toggle(studio, "cloud-by-part", "Part");
  ImGui::SameLine();
  command_toggle(studio, "cloud-by-shape", "Shape");
  ImGui::SameLine();
  command_toggle(studio, "cloud-by-displacement", "Displacement");
  separator_in_line(studio);
  command_toggle(studio, "cloud-pair", "Side by side");
  ImGui::SameLine();
  command_toggle(studio, "cloud-boxes", "Boxes");
}

}  // namespace archetype
