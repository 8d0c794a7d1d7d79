#include "ui/template_compare.h"

#include <imgui.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "core/learning/mirror_symmetry.h"
#include "ui/panels.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

PartDifference difference(const TemplatePart& here, const TemplatePart& there) {
  PartDifference result;
  result.name = here.name;
  // A box whose axes have other names is the same box.
  const Box a = with_nearest_axes(here.mean_box());
  const Box b = with_nearest_axes(there.mean_box());
  result.moved = (a.centre - b.centre).norm();
  result.larger = a.half_extent.prod() / b.half_extent.prod();
  result.turned_degrees = a.orientation.angularDistance(b.orientation) * 180 / std::numbers::pi;
  return result;
}

void cell(const Studio& studio, const char* format, double value, bool matters) {
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  ImGui::TableNextColumn();
  if (matters)
    ImGui::TextUnformatted(text);
  else
    muted_text(studio, text);
}

}  // namespace

std::shared_ptr<const PartTemplate> compared_template(const Studio& studio) {
  const Document& document = studio.history.current();
  if (studio.ui.compared.empty()) return nullptr;
  for (std::size_t i = 0; i < document.templates.size(); ++i)
    if (i != document.active && document.templates[i]->name == studio.ui.compared)
      return document.templates[i];
  return nullptr;
}

std::vector<PartDifference> compare_templates(const PartTemplate& a, const PartTemplate& b) {
  std::vector<PartDifference> differences;
  std::vector<bool> taken(b.parts.size(), false);
  for (std::size_t i = 0; i < a.parts.size(); ++i) {
    PartDifference found{.name = a.parts[i].name};
    for (std::size_t k = 0; k < b.parts.size() && !found.there; ++k) {
      if (taken[k] || b.parts[k].name != a.parts[i].name) continue;
      taken[k] = true;
      found = difference(a.parts[i], b.parts[k]);
      found.there = k;
    }
    found.here = i;
    differences.push_back(std::move(found));
  }
  for (std::size_t k = 0; k < b.parts.size(); ++k)
    if (!taken[k]) differences.push_back({.name = b.parts[k].name, .there = k});
  return differences;
}

void draw_compare_panel(Studio& studio) {
  const std::shared_ptr<const PartTemplate> other = compared_template(studio);
  const auto shared = studio.history.current();
  const PartTemplate* active = shared.active_template();
  if (!other || !active) return;
  section_title(studio, ("Against " + other->name).c_str());
  if (ImGui::BeginTable("compare", 4, ImGuiTableFlags_SizingStretchProp)) {
    for (const char* title : {"", "moved", "volume", "turned"}) {
      ImGui::TableNextColumn();
      muted_text(studio, title);
    }
    for (const PartDifference& each : compare_templates(*active, *other)) {
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(fitted(each.name, 110 * studio.fonts.scale).c_str());
      if (!each.here || !each.there) {
        ImGui::TableNextColumn();
        muted_text(studio, each.here ? "only here" : "only there");
        ImGui::TableNextColumn();
        ImGui::TableNextColumn();
        continue;
      }
      cell(studio, "%.3f", each.moved, each.moved > 5e-4);
      cell(studio, "× %.2f", each.larger, std::abs(each.larger - 1) > 5e-3);
      cell(studio, "%.1f°", each.turned_degrees, each.turned_degrees > 0.05);
    }
    ImGui::EndTable();
  }
  command_button(studio, "stop-comparing", "Stop comparing", {share_of_width(1), 0});
}

}  // namespace archetype
