// The fit of the shape in view: the terms of the energy (section 4.1), what the yaws scored, the parts that
// were found.
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "core/fitting/energy.h"
#include "core/model/part_colours.h"
#include "ui/icons.h"
#include "ui/panels.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4f", value);
  return text;
}

void energy_row(const Studio& studio, const char* name, const char* meaning, double value, double largest) {
  const Palette& p = colours(studio);
  muted_text(studio, name);
  tooltip(meaning);
  ImGui::SameLine(128 * studio.fonts.scale);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float text_width = ImGui::CalcTextSize("-0.0000").x;
  const float space = ImGui::GetContentRegionAvail().x - text_width - 8 * studio.fonts.scale;
  const float height = ImGui::GetTextLineHeight();
  const float share = largest > 0 ? static_cast<float>(std::clamp(value / largest, 0.0, 1.0)) : 0.0f;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const float top = low.y + height * 0.28f;
  const float bottom = low.y + height * 0.78f;
  const float rounding = 2 * studio.fonts.scale;
  draw->AddRectFilled({low.x, top}, {low.x + space, bottom}, ImGui::GetColorU32(p.raised), rounding);
  if (share > 0.01f)
    draw->AddRectFilled({low.x, top}, {low.x + space * share, bottom}, ImGui::GetColorU32(p.accent),
                        rounding);
  ImGui::SetCursorScreenPos({low.x + space + 8 * studio.fonts.scale, low.y});
  ImGui::TextUnformatted(number(value).c_str());
}

void draw_energy(const Studio& studio, const FitEnergy& energy) {
  const std::array terms{energy.shape_to_template, energy.template_to_shape, energy.features,
                         energy.deformation,       energy.smoothness,        energy.existence};
  const double largest = *std::max_element(terms.begin(), terms.end());
  energy_row(studio, "Shape to template", "How far the samples lie from the boxes of their parts.", terms[0],
             largest);
  energy_row(studio, "Template to shape", "How much of the boxes has no shape near it.", terms[1], largest);
  energy_row(studio, "Features",
             "How unlike the local shape is to what each part expects; null samples cost here.", terms[2],
             largest);
  energy_row(studio, "Deformation", "How far the boxes had to leave their means.", terms[3], largest);
  energy_row(studio, "Smoothness", "Where neighbouring samples belong to different parts.", terms[4],
             largest);
  energy_row(studio, "Existence", "How unlikely it is that just these parts are there.", terms[5], largest);
}

// What a yaw scored; what is not finite was not tried.
std::string yaw_text(const ShapeFit& fit, int quarter) {
  const double energy = fit.yaw_energies[static_cast<std::size_t>(quarter)];
  char text[48];
  if (std::isfinite(energy) && energy >= missing_must_exist_energy)
    std::snprintf(text, sizeof text, "%d° lacks", quarter * 90);
  else if (std::isfinite(energy))
    std::snprintf(text, sizeof text, "%d° %.3f", quarter * 90, energy);
  else
    std::snprintf(text, sizeof text, "%d° –", quarter * 90);
  return text;
}

// All four in a line, or two and two where the panel is too narrow for that.
void draw_yaws(Studio& studio, const ShapeFit& fit) {
  muted_text(studio, "Yaw");
  tooltip(
      "The total energy that each quarter turn about up reached with all parts as boxes, but for what the "
      "template says hardly any shape has; the least decides. That fit then takes round parts, leaves out "
      "what the shape lacks, and is tried once more, so that the number above may be another. With \"lacks\" "
      "a part that must exist was not found.");
  const float indent = 48 * studio.fonts.scale;
  const float room = ImGui::GetContentRegionAvail().x - indent;
  ImGui::PushFont(studio.fonts.small);
  float widest = 0;
  for (int quarter = 0; quarter < 4; ++quarter)
    widest = std::max(widest, ImGui::CalcTextSize(yaw_text(fit, quarter).c_str()).x);
  const int columns = widest + 4 * studio.fonts.scale <= room / 4 ? 4 : 2;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const int column = quarter % columns;
    if (quarter == 0 || column != 0)
      ImGui::SameLine(indent + room / static_cast<float>(columns) * static_cast<float>(column));
    else
      ImGui::SetCursorPosX(indent);
    const std::string text = yaw_text(fit, quarter);
    if (quarter == fit.yaw_quarters)
      ImGui::TextColored(colours(studio).accent, "%s", text.c_str());
    else
      muted_text(studio, text);
    mark_target(studio, "fit:yaw:" + std::to_string(quarter * 90));
  }
  ImGui::PopFont();
}

void draw_parts(const Studio& studio, const ViewFit& view) {
  std::vector<std::size_t> counts(view.part_template->parts.size() + 1);
  for (const std::int16_t label : view.fit.labels) ++counts[static_cast<std::size_t>(label + 1)];
  const auto all = static_cast<double>(std::max<std::size_t>(1, view.fit.labels.size()));
  for (std::size_t i = 0; i <= view.part_template->parts.size(); ++i) {
    const bool null = i == view.part_template->parts.size();
    const Rgb rgb = part_colour(*view.part_template, null ? -1 : static_cast<int>(i));
    const bool absent = !null && !view.fit.parts[i].present;
    const std::string name = null ? "no part" : view.part_template->parts[i].name;
    char share[48];
    std::snprintf(share, sizeof share, "%.1f %%", 100 * static_cast<double>(counts[null ? 0 : i + 1]) / all);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float line = ImGui::GetTextLineHeight();
    ImGui::GetWindowDrawList()->AddRectFilled({low.x, low.y + line * 0.2f},
                                              {low.x + line * 0.6f, low.y + line * 0.8f},
                                              IM_COL32(rgb[0], rgb[1], rgb[2], 255), 3 * studio.fonts.scale);
    ImGui::Dummy({line * 0.6f, line});
    ImGui::SameLine();
    if (absent || null)
      muted_text(studio, name);
    else
      ImGui::TextUnformatted(name.c_str());
    ImGui::SameLine(ImGui::GetContentRegionMax().x - 70 * studio.fonts.scale);
    muted_text(studio, absent ? "absent" : share);
  }
}

}  // namespace

void draw_fit_panel(Studio& studio) {
  section_title(studio, "Fit");
  const std::shared_ptr<const ViewFit> view = studio.shape.fit;
  if (!view) {
    const PartTemplate* active = studio.history.current().active_template();
    if (!studio.shape.record)
      muted_paragraph(studio, "Click a shape in the collection: the template is fitted to it at once.");
    else if (!active || active->parts.empty())
      muted_paragraph(studio, "With a template of at least one part, the fit of this shape shows here.");
    else
      muted_paragraph(studio, "Fitting…");
    return;
  }
  const std::vector<std::string> missing = missing_parts(*view);
  const FitEnergy energy = energy_without_missing(*view);
  ImGui::PushFont(studio.fonts.title);
  ImGui::TextUnformatted(number(energy.total()).c_str());
  ImGui::PopFont();
  ImGui::SameLine();
  char text[96];
  std::snprintf(text, sizeof text, "energy, %s %d alternations",
                view->fit.converged ? "settled after" : "stopped after", view->fit.alternations);
  ImGui::AlignTextToFramePadding();
  muted_text(studio, text);
  for (const std::string& part : missing)
    ImGui::TextColored(colours(studio).warning, "%s must exist, and was not found", part.c_str());
  draw_energy(studio, energy);
  draw_yaws(studio, view->fit);
  ImGui::Dummy({0, 2 * studio.fonts.scale});
  draw_parts(studio, *view);
  ImGui::Dummy({0, 2 * studio.fonts.scale});
  command_button(studio, "fit-all", std::string(icon::play) + "  Fit all", {share_of_width(3), 0});
  ImGui::SameLine();
  command_button(studio, "learn", "Learn", {share_of_width(2), 0});
  ImGui::SameLine();
  command_button(studio, "adopt-fit", "Take boxes", {share_of_width(1), 0});
}

}  // namespace archetype
