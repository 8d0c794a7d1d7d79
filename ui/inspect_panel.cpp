// The right side of the window while a single fit is inspected, and the tools above it.
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "ui/icons.h"
#include "ui/inspect_panels.h"
#include "ui/kept_choices.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

struct Term {
  const char* name;
  const char* meaning;
  // What shows it on the shape: a command with what it is to colour by, or a switch; none for the last.
  const char* command = nullptr;
  const char* colour = nullptr;
  const char* click = "";
};
constexpr std::array<Term, 6> term_names{
    Term{"Shape to template", "How far the samples lie from the boxes of their parts (equation 3).",
         "inspect-colour", "distance", "\nClick to colour the shape by it."},
    Term{"Template to shape", "How much of the boxes has no shape near it (equation 4).",
         "inspect-template-points", nullptr, "\nClick to see it at the points of the template."},
    Term{"Features",
         "How unlike the local shape is to what each part expects; samples without a part cost here "
         "(equation 5).",
         "inspect-colour", "features", "\nClick to colour the shape by it."},
    Term{"Deformation", "How far the boxes had to leave their means (equation 6).", "inspect-mean-boxes",
         nullptr, "\nClick to see their means."},
    Term{"Smoothness", "Where neighbouring samples belong to different parts (equation 7).", "inspect-colour",
         "smoothness", "\nClick to colour the shape by it."},
    Term{"Existence", "How unlikely it is that just these parts are there."}};

// Of ascending values.
double at_share(const std::vector<double>& values, double share) {
  const double at = share * static_cast<double>(values.size() - 1);
  const auto low = static_cast<std::size_t>(at);
  const std::size_t high = std::min(low + 1, values.size() - 1);
  const double part = at - static_cast<double>(low);
  return (1 - part) * values[low] + part * values[high];
}

double share_below(const std::vector<double>& values, double value) {
  return static_cast<double>(std::ranges::lower_bound(values, value) - values.begin()) /
         static_cast<double>(values.size());
}

bool is_on_shape(const Studio& studio, const Term& term) {
  if (!term.command) return false;
  if (term.colour) return studio.settings.inspect_colour == term.colour;
  const Command* command = find_command(studio, term.command);
  return command && command->checked(studio);
}

// A second click takes it from the shape.
void switch_on_shape(Studio& studio, const Term& term) {
  if (!term.command) return;
  std::vector<std::string> arguments;
  if (term.colour)
    arguments.emplace_back(is_on_shape(studio, term) ? name_of(InspectColour::part) : term.colour);
  run_command(studio, term.command, arguments);
}

// A bar for the value; behind it the tenth to the ninetieth percentile of the cluster as a band, its median
// as a line. Without a cluster the bar's end is at `otherwise`.
void draw_bar(Studio& studio, const Term& term, double value, const std::vector<double>* cluster,
              double otherwise) {
  const Palette& p = colours(studio);
  const float scale = studio.fonts.scale;
  const bool known = cluster && cluster->size() > 1;
  const bool on = is_on_shape(studio, term);
  if (on) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 size(ImGui::GetContentRegionAvail().x, ImGui::GetTextLineHeight());
    ImGui::GetWindowDrawList()->AddRectFilled(
        {at.x - 4 * scale, at.y - 3 * scale}, {at.x + size.x + 4 * scale, at.y + size.y + 3 * scale},
        ImGui::GetColorU32(ImVec4(p.accent.x, p.accent.y, p.accent.z, 0.35F)), 3 * scale);
  }
  ImGui::BeginGroup();
  if (on)
    ImGui::TextUnformatted(term.name);
  else
    muted_text(studio, term.name);
  ImGui::SameLine(132 * scale);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float text_width = ImGui::CalcTextSize("-0.0000").x;
  const float space = std::max(20 * scale, ImGui::GetContentRegionAvail().x - text_width - 8 * scale);
  const float height = ImGui::GetTextLineHeight();
  const double largest = std::max({std::abs(value), known ? at_share(*cluster, 0.95) : otherwise, 1e-9});
  const auto x = [&](double v) {
    return low.x + space * static_cast<float>(std::clamp(v / largest, 0.0, 1.0));
  };
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled({low.x, low.y + height * 0.1F}, {low.x + space, low.y + height * 0.9F},
                     ImGui::GetColorU32(p.raised), 2 * scale);
  if (known) {
    ImVec4 band = p.muted;
    band.w = 0.35F;
    draw.AddRectFilled({x(at_share(*cluster, 0.1)), low.y + height * 0.1F},
                       {x(at_share(*cluster, 0.9)) + 1, low.y + height * 0.9F}, ImGui::GetColorU32(band));
  }
  const bool unusual = known && share_below(*cluster, value) > 0.9;
  draw.AddRectFilled({low.x, low.y + height * 0.32F}, {x(value), low.y + height * 0.68F},
                     ImGui::GetColorU32(unusual ? p.warning : p.accent), 2 * scale);
  if (known)
    draw.AddLine({x(at_share(*cluster, 0.5)), low.y + height * 0.05F},
                 {x(at_share(*cluster, 0.5)), low.y + height * 0.95F}, ImGui::GetColorU32(p.text),
                 1.5F * scale);
  ImGui::SetCursorScreenPos({low.x + space + 8 * scale, low.y});
  ImGui::Text("%.4f", value);
  ImGui::EndGroup();
  if (ImGui::IsItemClicked()) switch_on_shape(studio, term);
  mark_target(studio, "inspect:term:" + std::string(term.name));
  char text[400];
  if (known)
    std::snprintf(text, sizeof text,
                  "%s\n%zu shapes of the cluster: median %.4f, tenth to ninetieth percentile %.4f to "
                  "%.4f; %.0f %% of them have less.%s",
                  term.meaning, cluster->size(), at_share(*cluster, 0.5), at_share(*cluster, 0.1),
                  at_share(*cluster, 0.9), 100 * share_below(*cluster, value), term.click);
  else
    std::snprintf(text, sizeof text, "%s%s", term.meaning, term.click);
  tooltip(text);
}

// The whole, and each part; a click chooses whose bars and boxes are shown.
void draw_part_choice(Studio& studio, const FitLook& look) {
  const std::optional<std::size_t> chosen = inspected_part(studio, look);
  const auto line = [&](const std::string& name, std::optional<std::size_t> part, double energy,
                        bool absent) {
    ImGui::PushID(part ? static_cast<int>(*part) : -1);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float height = ImGui::GetTextLineHeight();
    if (ImGui::Selectable("##part", chosen == part)) pick_inspected_part(studio, part);
    mark_target(studio, "inspect:part:" + name);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    if (part) {
      const Rgb rgb = part_colour(*look.part_template, static_cast<int>(*part));
      draw.AddRectFilled({low.x + 2, low.y + height * 0.2F},
                         {low.x + 2 + height * 0.6F, low.y + height * 0.8F},
                         IM_COL32(rgb[0], rgb[1], rgb[2], 255), 3 * studio.fonts.scale);
    }
    const float width = ImGui::GetContentRegionAvail().x;
    const ImU32 colour = ImGui::GetColorU32(absent ? colours(studio).muted : colours(studio).text);
    draw.AddText({low.x + height, low.y}, colour, fitted(name, width - 110 * studio.fonts.scale).c_str());
    char text[32];
    std::snprintf(text, sizeof text, absent ? "absent" : "%.4f", energy);
    draw.AddText({low.x + width - ImGui::CalcTextSize(text).x - 4, low.y}, colour, text);
    ImGui::PopID();
  };
  line("Whole fit", std::nullopt, look.fit.energy.total(), false);
  for (std::size_t i = 0; i < look.fit.parts.size(); ++i)
    line(look.part_template->parts[i].name, i, look.terms.parts[i].total(), !look.fit.parts[i].present);
}

}  // namespace

void draw_fit_terms_panel(Studio& studio) {
  section_title(studio, "Energy against the cluster");
  const Inspection& inspection = studio.inspection;
  const std::shared_ptr<const FitLook> look = inspection.main.look;
  if (!look || look->shape != inspection.main.shape) {
    muted_paragraph(studio, inspection.main.shape && !inspection.main.shape->fit
                                ? "This shape was not fitted yet: Ctrl+Enter fits the template to all shapes."
                                : "The terms of the energy show here, for the whole fit and for each part.");
    return;
  }
  draw_part_choice(studio, *look);
  ImGui::Dummy({0, 3 * studio.fonts.scale});
  const std::optional<std::size_t> part = inspected_part(studio, *look);
  // The distribution is that of the template whose fits it was read of.
  const ClusterTerms* cluster = nullptr;
  const auto& fit = inspection.main.shape->fit;
  const bool same = fit && inspection.cluster && inspection.cluster->of.part_template == fit->part_template &&
                    inspection.main.shape->part_template == look->part_template;
  if (same) cluster = &inspection.cluster->terms;
  const FitEnergy& energy = part ? look->terms.parts[*part] : look->fit.energy;
  double largest = 0;
  for (const auto term : energy_terms) largest = std::max(largest, std::abs(energy.*term));
  for (std::size_t term = 0; term < energy_terms.size(); ++term) {
    const std::vector<double>* values = nullptr;
    if (cluster && !part) values = &cluster->whole[term];
    if (cluster && part && *part < cluster->parts.size()) values = &cluster->parts[*part][term];
    draw_bar(studio, term_names[term], energy.*energy_terms[term], values, largest);
  }
}

void draw_inspect_panel(Studio& studio) {
  draw_corrections_panel(studio);
  draw_fit_terms_panel(studio);
}

void draw_inspect_tools(Studio& studio) {
  command_button(studio, "undo", icon::undo);
  ImGui::SameLine();
  command_button(studio, "redo", icon::redo);
  separator_in_line(studio);
  command_toggle(studio, "paint-labels", std::string(icon::draw) + " Brush");
  separator_in_line(studio);
  const std::pair<const char*, const char*> toggles[] = {{"inspect-fitted-boxes", "Boxes"},
                                                         {"inspect-mean-boxes", "Means"},
                                                         {"inspect-template-points", "Template points"},
                                                         {"inspect-correspondences", "Correspondences"},
                                                         {"inspect-samples", "Samples"}};
  for (const auto& [command, label] : toggles) {
    const float width = ImGui::CalcTextSize(label).x + 2 * ImGui::GetStyle().FramePadding.x;
    if (ImGui::GetContentRegionAvail().x < width) break;  // rather than cut off
    command_toggle(studio, command, label);
    ImGui::SameLine();
  }
  const std::pair<InspectColour, const char*> by[] = {
      {InspectColour::part, "Parts"},
      {InspectColour::plain, "Plain"},
      {InspectColour::shape_to_template, "Distance to the box"},
      {InspectColour::features, "Features"},
      {InspectColour::smoothness, "Smoothness"}};
  if (ImGui::GetContentRegionAvail().x > 150 * studio.fonts.scale) {
    separator_in_line(studio);
    ImGui::SetNextItemWidth(140 * studio.fonts.scale);
    const auto now =
        std::ranges::find(by, studio.ui.inspect.colour, &std::pair<InspectColour, const char*>::first);
    if (ImGui::BeginCombo("##colour", now->second)) {
      for (const auto& [colour, name] : by)
        if (ImGui::Selectable(name, colour == studio.ui.inspect.colour))
          studio.settings.inspect_colour = name_of(colour);
      ImGui::EndCombo();
    }
    mark_target(studio, "inspect:colour");
    tooltip("What the surface and the samples are coloured by");
  } else {
    ImGui::NewLine();
  }
}

}  // namespace archetype
