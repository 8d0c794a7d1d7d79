#include "ui/cluster_card.h"

#include <algorithm>
#include <cstdio>

#include "core/base/error.h"
#include "core/model/part_colours.h"
#include "core/report/box_faces.h"
#include "core/session/cluster_size.h"
#include "ui/clusters_view.h"
#include "ui/icons.h"
#include "ui/learning_actions.h"
#include "ui/part_highlight.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

constexpr float picture_height = 118;
constexpr std::size_t most_parts = 16;  // that the legend names

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f", value);
  return text;
}

std::string count_of(const ShapeCluster& cluster) {
  const std::string all = to_string(ClusterSize{cluster.all, cluster.outliers});
  return cluster.shown.size() == cluster.all ? all : count_text(cluster.shown.size()) + " of " + all;
}

std::string spread_text(const char* what, const Vec3& spread) {
  char text[96];
  std::snprintf(text, sizeof text, "\n%s ± %.3f  %.3f  %.3f", what, spread.x(), spread.y(), spread.z());
  return text;
}

std::string legend_name(const TemplatePart& part, float scale) {
  std::string name = fitted(part.name, 92 * scale);
  if (!is_rare(part)) return name;
  char share[16];
  std::snprintf(share, sizeof share, " %.0f %%", 100 * part.existence);
  return name + share;
}

// A swatch and a name; a click highlights the part on all shapes.
void draw_part(Studio& studio, const TemplateRecord& record, std::size_t k,
               std::optional<std::size_t> highlighted) {
  const Palette& p = colours(studio);
  const TemplatePart& part = record.part_template.parts[k];
  const float scale = studio.fonts.scale;
  const float line = ImGui::GetTextLineHeight();
  const std::string name = legend_name(part, scale);
  const ImVec2 size(line * 0.8f + ImGui::CalcTextSize(name.c_str()).x + 6 * scale, line + 2 * scale);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  ImGui::PushID(static_cast<int>(k));
  if (ImGui::InvisibleButton("part", size)) select_part_of(studio, record, k);
  mark_target(studio, "cluster-part:" + std::to_string(record.id) + ":" + part.name);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const bool chosen = highlighted == k;
  if (chosen || ImGui::IsItemHovered())
    draw.AddRectFilled(
        {low.x - 2 * scale, low.y}, {low.x + size.x, low.y + size.y},
        ImGui::GetColorU32(chosen ? ImVec4(p.accent.x, p.accent.y, p.accent.z, 0.4f) : p.hovered), 3 * scale);
  const Rgb rgb = part_colour(record.part_template, static_cast<int>(k));
  draw.AddRectFilled({low.x, low.y + line * 0.25f}, {low.x + line * 0.6f, low.y + line * 0.85f},
                     IM_COL32(rgb[0], rgb[1], rgb[2], 255), 2 * scale);
  draw.AddText({low.x + line * 0.8f, low.y + scale},
               ImGui::GetColorU32((highlighted || is_rare(part)) && !chosen ? p.muted : p.text),
               name.c_str());
  char share[64];
  std::snprintf(share, sizeof share, "\nin %.0f %% of the shapes%s", 100 * part.existence,
                is_rare(part) ? ", hence dashed" : "");
  const std::string text = part.name + share + spread_text("centre", part.position.stddev) +
                           spread_text("half size", part.scale.stddev) + "\nClick to see it on all shapes";
  tooltip(text.c_str());
  ImGui::PopID();
}

void draw_legend(Studio& studio, const TemplateRecord& record, float right) {
  const std::optional<std::size_t> highlighted = highlighted_part(studio, record.part_template);
  const auto& parts = record.part_template.parts;
  ImGui::PushFont(studio.fonts.small);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {6 * studio.fonts.scale, 1 * studio.fonts.scale});
  const float left = ImGui::GetCursorScreenPos().x;
  float x = left;
  for (std::size_t k = 0; k < std::min(parts.size(), most_parts); ++k) {
    const float width = ImGui::GetTextLineHeight() * 0.8f +
                        ImGui::CalcTextSize(legend_name(parts[k], studio.fonts.scale).c_str()).x +
                        6 * studio.fonts.scale;
    if (k > 0 && x + width <= right) ImGui::SameLine();
    if (k > 0 && x + width > right) x = left;
    draw_part(studio, record, k, highlighted);
    x += width + ImGui::GetStyle().ItemSpacing.x;
  }
  if (parts.size() > most_parts) muted_text(studio, "and " + plural(parts.size() - most_parts, "more part"));
  ImGui::PopStyleVar();
  ImGui::PopFont();
}

void select_members(Studio& studio, const ShapeCluster& cluster) {
  std::vector<ShapeId> members;
  for (const std::size_t row : cluster.shown) members.push_back(studio.collection.rows()[row].id);
  select_only(studio.ui.selection, std::move(members));
}

void show_only(Studio& studio, const FitTable& table, TemplateId id) {
  auto& hidden = studio.ui.shown.filter.hidden_templates;
  hidden.clear();
  for (const TemplateRecord& record : table.templates)
    if (record.id != id) hidden.push_back(record.id);
}

void draw_menu(Studio& studio, const FitTable& table, const ShapeCluster& cluster) {
  const TemplateRecord& record = table.templates[cluster.part_template];
  const std::string target = "cluster-menu:" + std::to_string(record.id);
  if (!ImGui::BeginPopup("menu")) return;
  if (ImGui::MenuItem("Look at its boxes")) {
    look_at(studio, record.part_template, "its cluster");
    studio.ui.centre = CentreView::shape;
  }
  mark_target(studio, target + ":look");
  if (ImGui::MenuItem("Where it comes from", nullptr, false, studio.collection.content.learning != nullptr)) {
    try {
      show_in_family_tree(studio, record.id);
    } catch (const Error& error) {
      say(studio, Severity::warning, error.what());
    }
  }
  mark_target(studio, target + ":tree");
  if (ImGui::MenuItem("Select its shapes", nullptr, false, !cluster.shown.empty()))
    select_members(studio, cluster);
  mark_target(studio, target + ":select");
  if (ImGui::MenuItem("Show only this cluster")) show_only(studio, table, record.id);
  mark_target(studio, target + ":only");
  ImGui::EndPopup();
}

void draw_template(Studio& studio, const FitTable& table, const ShapeCluster& cluster, float width) {
  const TemplateRecord& record = table.templates[cluster.part_template];
  const float scale = studio.fonts.scale;
  ImGui::PushID(static_cast<int>(record.id));
  const float right = ImGui::GetCursorScreenPos().x + width;
  draw_cluster_picture(studio, record, "cluster-picture:" + std::to_string(record.id),
                       {width, picture_height * scale});
  const float button = ImGui::GetFrameHeight();
  ImGui::AlignTextToFramePadding();
  ImGui::PushFont(studio.fonts.bold);
  ImGui::TextUnformatted(fitted(record.part_template.name, width - button - 6 * scale).c_str());
  ImGui::PopFont();
  ImGui::SameLine();
  ImGui::SetCursorScreenPos({right - button, ImGui::GetCursorScreenPos().y});
  if (ImGui::Button(icon::more, {button, 0})) ImGui::OpenPopup("menu");
  mark_target(studio, "cluster-menu:" + std::to_string(record.id));
  draw_menu(studio, table, cluster);
  // Fits with what the rounds leave are made once, after the last.
  const bool to_come = cluster.all == 0 && learning_job(studio).has_value();
  const std::string energy = cluster.all == 0 ? "" : ", mean energy " + number(cluster.mean_energy);
  muted_text(studio, to_come ? "its shapes come when learning ends" : count_of(cluster) + energy);
  if (record.iteration > 0) tooltip(("Learned in round " + std::to_string(record.iteration)).c_str());
  draw_legend(studio, record, right);
  ImGui::PopID();
}

void draw_apart(Studio& studio, const ShapeCluster& cluster, float width) {
  const bool outliers = cluster.kind == ClusterKind::outliers;
  ImGui::AlignTextToFramePadding();
  ImGui::PushFont(studio.fonts.bold);
  ImGui::TextUnformatted(outliers ? "Outliers" : "Without a fit");
  ImGui::PopFont();
  muted_text(studio, count_of(cluster) + (outliers ? ", mean energy " + number(cluster.mean_energy) : ""));
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width);
  ImGui::PushStyleColor(ImGuiCol_Text, colours(studio).muted);
  ImGui::TextUnformatted(
      outliers ? "No template explains these well; nothing is learned from them. Point at one: + "
                 "makes a template from it."
               : "Fit the templates to them, or learn from them.");
  ImGui::PopStyleColor();
  ImGui::PopTextWrapPos();
  if (!outliers) command_button(studio, "fit-all", std::string(icon::play) + "  Fit all", {width, 0});
}

}  // namespace

float draw_cluster_card(Studio& studio, const ShapeCluster& cluster, float width) {
  const float top = ImGui::GetCursorScreenPos().y;
  const std::shared_ptr<const FitTable> table = studio.ui.clusters.of_table;
  ImGui::BeginGroup();
  if (cluster.kind == ClusterKind::members && table)
    draw_template(studio, *table, cluster, width);
  else
    draw_apart(studio, cluster, width);
  ImGui::EndGroup();
  return ImGui::GetItemRectMax().y - top;
}

float guessed_card_height(const Studio& studio) {
  return (picture_height + 110) * studio.fonts.scale;
}

void show_in_family_tree(Studio& studio, TemplateId part_template) {
  const std::shared_ptr<const LearningRecord> record = studio.collection.content.learning;
  if (!record) throw Error("nothing was learned yet");
  show_learning(studio);
  for (std::size_t i = record->steps.size(); i-- > 0;) {
    const auto& templates = record->steps[i].templates;
    const auto found = std::ranges::find(templates, part_template);
    if (found == templates.end()) continue;
    studio.ui.learning = {i + 1, static_cast<std::size_t>(found - templates.begin())};
    return;
  }
  throw Error("this template came of no round of learning");
}

}  // namespace archetype
