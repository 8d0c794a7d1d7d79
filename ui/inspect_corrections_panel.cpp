// What else the shape in view could be, and what a person has said of it.
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/fitting/energy.h"
#include "ui/icons.h"
#include "ui/inspect_actions.h"
#include "ui/inspect_panels.h"
#include "ui/project_actions.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

bool is_pinned(const ShapeCorrection& correction, const std::string& name, int yaw) {
  const bool template_pinned = correction.part_template.empty() || correction.part_template == name;
  const bool yaw_pinned = !correction.yaw_quarters || *correction.yaw_quarters == yaw;
  const bool any = correction.yaw_quarters || !correction.part_template.empty();
  return any && template_pinned && yaw_pinned;
}

// Nothing chosen is the fit of the project.
void choose(Studio& studio, std::optional<ChosenAlternative> alternative) {
  studio.ui.inspect.chosen = alternative;
  studio.ui.inspect.step.reset();
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f", value);
  return text;
}

std::string name_of(const Alternatives& all, const FitAlternative& alternative) {
  return all.templates[alternative.part_template]->name + " at " +
         std::to_string(alternative.fit.yaw_quarters * 90) + "°";
}

std::string sum_of(const Alternatives& all, const FitAlternative& alternative,
                   const ShapeCorrection& correction, bool is_stored) {
  const double energy = alternative.fit.energy.total();
  const double decides = deciding_energy(all, alternative, correction);
  std::string text = name_of(all, alternative);
  if (energy >= missing_must_exist_energy) {
    text += ": a part that must exist was not found";
  } else {
    text += "\nenergy of the fit  " + number(energy) + "\nto compare templates  " +
            number(alternative.choice - energy);
    if (!std::isfinite(decides))
      text += "\nother shapes are so clearly against this yaw that it is not tried";
    else if (all.yaw_costs && !correction.yaw_quarters)
      text += "\nother shapes on this yaw  " + number(decides - alternative.choice);
    if (std::isfinite(decides)) text += "\ndecides  " + number(decides);
  }
  return text + (is_stored ? "\nThis is the fit of the project." : "\nClick to see it.");
}

void draw_alternative(Studio& studio, const Alternatives& all, std::size_t part_template, int yaw) {
  const TemplateRecord& record = all.of.shape->templates[part_template];
  const ChosenAlternative which{record.id, yaw};
  const FitAlternative* found = find_alternative(all, which);
  if (!found) {
    muted_text(studio, "–");
    return;
  }
  const auto& stored = all.of.shape->fit;
  const bool is_stored =
      stored && which == ChosenAlternative{stored->part_template, stored->fit.yaw_quarters};
  const auto shown = shown_alternative(studio);
  const bool is_shown = shown ? *shown == which : is_stored;
  const ShapeCorrection correction = correction_in_view(studio);
  const double energy = found->fit.energy.total();
  const double decides = deciding_energy(all, *found, correction);
  const bool lacks = energy >= missing_must_exist_energy;
  std::string label = lacks ? "lacks" : number(std::isfinite(decides) ? decides : found->choice);
  if (is_pinned(correction, record.part_template.name, yaw)) label = std::string(icon::check) + label;
  ImGui::PushID(static_cast<int>(part_template) * 4 + yaw);
  const Palette& p = colours(studio);
  ImGui::PushStyleColor(ImGuiCol_Text, is_stored ? p.accent : std::isfinite(decides) ? p.text : p.muted);
  if (ImGui::Selectable(label.c_str(), is_shown))
    choose(studio, is_stored && !coming_fit(studio) ? std::nullopt : std::optional(which));
  ImGui::PopStyleColor();
  mark_target(studio, "alternative:" + record.part_template.name + ":" + std::to_string(yaw * 90));
  tooltip(sum_of(all, *found, correction, is_stored).c_str());
  ImGui::PopID();
}

// How the table is to be read: one line, whatever is decided.
void draw_decision(Studio& studio, const Alternatives& all) {
  const bool some_ruled_out = std::ranges::any_of(all.fits, [&](const FitAlternative& each) {
    return !std::isfinite(deciding_energy(all, each, correction_in_view(studio)));
  });
  muted_text(studio, some_ruled_out ? "The least decides; other shapes rule the grey ones out."
                                    : "The least decides.");
  tooltip(
      "The energy of the fit, with what the spreads of its template cost (a template that expects nothing in "
      "particular would fit every shape), with its distances weighted alike for all "
      "templates, and what other shapes say of the yaw. Point at a number to see its sum.");
}

void draw_alternatives(Studio& studio) {
  section_title(studio, "Templates and yaws");
  const Alternatives* all = alternatives_of_view(studio);
  if (!all) {
    muted_paragraph(studio, studio.inspection.main.shape
                                ? "Trying them…"
                                : "What other templates and yaws scored shows here.");
    return;
  }
  if (all->templates.empty()) {
    muted_paragraph(studio, "The project has no templates yet: fit the template to all shapes, or learn.");
    return;
  }
  const float scale = studio.fonts.scale;
  if (ImGui::BeginTable("##alternatives", 5, ImGuiTableFlags_SizingStretchProp)) {
    ImGui::TableSetupColumn("Template", 0, 1.6F);
    for (const char* yaw : {"0°", "90°", "180°", "270°"}) ImGui::TableSetupColumn(yaw, 0, 1);
    ImGui::TableHeadersRow();
    for (std::size_t t = 0; t < all->templates.size(); ++t) {
      ImGui::TableNextRow();
      ImGui::TableNextColumn();
      const std::string& name = all->templates[t]->name;
      ImGui::TextUnformatted(fitted(name, ImGui::GetContentRegionAvail().x).c_str());
      tooltip(name.c_str());
      for (int yaw = 0; yaw < 4; ++yaw) {
        ImGui::TableNextColumn();
        draw_alternative(studio, *all, t, yaw);
      }
    }
    ImGui::EndTable();
  }
  draw_decision(studio, *all);
  ImGui::Dummy({0, 2 * scale});
  command_button(studio, "pin-shown", std::string(icon::check) + "  Pin what is shown",
                 {share_of_width(2), 0});
  ImGui::SameLine();
  command_button(studio, "inspect-stored", "Back to the project's", {share_of_width(1), 0});
}

void draw_pins(Studio& studio, const ShapeCorrection& correction) {
  const auto line = [&](const std::string& text, const char* command) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(text.c_str());
    ImGui::SameLine(ImGui::GetContentRegionMax().x - 56 * studio.fonts.scale);
    command_button(studio, command, "Free", {56 * studio.fonts.scale, 0});
  };
  if (correction.yaw_quarters)
    line("Yaw pinned to " + std::to_string(*correction.yaw_quarters * 90) + "°", "free-yaw");
  if (!correction.part_template.empty())
    line("Template pinned: " + correction.part_template, "free-template");
  std::size_t points = 0;
  for (const auto& [part, samples] : correction.pinned) points += samples.size();
  if (points > 0) line(plural(points, "point") + " pinned", "free-points");
}

void draw_brush(Studio& studio) {
  InspectOptions& options = studio.ui.inspect;
  if (!options.painting) return;
  const auto& look = studio.inspection.main.look;
  if (!look) return;
  const float scale = studio.fonts.scale;
  const auto choice = [&](const char* name, const std::string& part, bool freeing, const Rgb& rgb) {
    const bool on = options.freeing == freeing && (freeing || options.paint_part == part);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float height = ImGui::GetTextLineHeight();
    ImGui::PushID(name);
    if (ImGui::Selectable("##brush", on)) {
      options.freeing = freeing;
      options.paint_part = part;
    }
    mark_target(studio, std::string("brush:") + name);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled({low.x + 2, low.y + height * 0.2F}, {low.x + 2 + height * 0.6F, low.y + height * 0.8F},
                       IM_COL32(rgb[0], rgb[1], rgb[2], 255), 3 * scale);
    draw.AddText({low.x + height, low.y}, ImGui::GetColorU32(colours(studio).text), name);
    ImGui::PopID();
  };
  muted_text(studio, "The brush makes what it touches");
  for (std::size_t i = 0; i < look->part_template->parts.size(); ++i) {
    const std::string& name = look->part_template->parts[i].name;
    choice(name.c_str(), name, false, part_colour(*look->part_template, static_cast<int>(i)));
  }
  choice("no part", "", false, part_colour(-1));
  choice("free again", "", true, part_colour(-1));
  auto radius = static_cast<float>(options.brush_radius);
  ImGui::SetNextItemWidth(-1);
  if (ImGui::SliderFloat("##radius", &radius, static_cast<float>(least_brush_radius),
                         static_cast<float>(largest_brush_radius), "radius %.2f",
                         ImGuiSliderFlags_Logarithmic))
    options.brush_radius = radius;
  mark_target(studio, "brush:radius");
  tooltip("Of the brush, in the unit of the template. Ctrl and the wheel change it too.");
}

// Lines that come and go.
void draw_remarks(Studio& studio, const ShapeCorrection& correction) {
  if (const Alternatives* all = alternatives_of_view(studio))
    if (const std::string why = why_decided(*all, correction); !why.empty())
      muted_paragraph(studio, why.c_str());
  draw_pins(studio, correction);
  if (correction.empty())
    muted_paragraph(
        studio,
        "What is pinned, painted or marked here is fitted at once, and holds in every later fit and in "
        "learning.");
  const std::size_t outdated = outdated_fits(studio);
  if (outdated > 0 && (!corrections_settled(studio) || is_fitted(studio, studio.collection.path))) {
    muted_paragraph(studio, (plural(outdated, "shape") + " to be fitted anew…").c_str());
  } else if (outdated > 0) {
    ImGui::TextColored(colours(studio).warning, "%s", (plural(outdated, "fit") + " out of date").c_str());
    command_button(studio, "refit-corrected", std::string(icon::play) + "  Fit them anew", {-1, 0});
  }
}

}  // namespace

// What is clicked stays where it is while fits come in: remarks are below it.
void draw_corrections_panel(Studio& studio) {
  draw_alternatives(studio);
  section_title(studio, "Corrections");
  command_toggle(studio, "mark-outlier", std::string(icon::warning) + "  Outlier");
  ImGui::SameLine();
  command_toggle(studio, "learn-from-shape", std::string(icon::check) + "  Learn from this");
  ImGui::SameLine();
  command_toggle(studio, "paint-labels", std::string(icon::draw) + "  Brush");
  command_button(studio, "template-from-shape", "Make a template", {share_of_width(2), 0});
  ImGui::SameLine();
  command_button(studio, "inspect-beside", studio.ui.inspect.beside ? "Another beside" : "Show one beside",
                 {share_of_width(1), 0});
  if (studio.ui.inspect.beside) command_button(studio, "inspect-alone", "Only this shape", {-1, 0});
  draw_brush(studio);
  draw_remarks(studio, correction_in_view(studio));
}

}  // namespace archetype
