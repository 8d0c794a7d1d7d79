// The numbers of the selected part. A number is dragged or typed; while that goes on the fit follows, and it
// becomes one step of the history.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <functional>
#include <utility>

#include "core/model/part_colours.h"
#include "core/session/actions.h"
#include "core/session/mirror_pairs.h"
#include "ui/box_angles.h"
#include "ui/panels.h"
#include "ui/selection.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

using Apply = std::function<void(const Vec3&, Stage)>;

void row_label(const Studio& studio, const char* name, const char* hint) {
  ImGui::AlignTextToFramePadding();
  muted_text(studio, name);
  if (hint) tooltip(hint);
  ImGui::SameLine(84 * studio.fonts.scale);
}

// Three fields; every change while one is held is live, letting go ends the edit.
void vector_row(Studio& studio, const char* name, const char* hint, const Vec3& value, float speed,
                const char* format, const Apply& apply) {
  row_label(studio, name, hint);
  const float gap = 4 * studio.fonts.scale;
  const float width = (ImGui::GetContentRegionAvail().x - 2 * gap) / 3;
  ImGui::PushID(name);
  Vec3 edited = value;
  bool changed = false;
  bool over = false;
  for (int axis = 0; axis < 3; ++axis) {
    if (axis > 0) ImGui::SameLine(0, gap);
    ImGui::SetNextItemWidth(width);
    ImGui::PushID(axis);
    changed |=
        ImGui::DragScalar("##value", ImGuiDataType_Double, &edited[axis], speed, nullptr, nullptr, format);
    over |= ImGui::IsItemDeactivatedAfterEdit();
    mark_target(studio, std::string("field:") + name + "." + "xyz"[axis]);
    ImGui::PopID();
  }
  ImGui::PopID();
  if (over)
    apply(edited, Stage::done);
  else if (changed)
    apply(edited, Stage::live);
}

void preview_name(Studio& studio, std::size_t part, const std::string& name) {
  Document document = studio.history.current();
  PartTemplate renamed = *document.active_template();
  renamed.parts[part].name = name;
  document.templates[document.active] = std::make_shared<const PartTemplate>(std::move(renamed));
  studio.history.preview(std::move(document));
}

void name_row(Studio& studio, std::size_t part, const TemplatePart& shown) {
  row_label(studio, "Name", "What people call the part. F2 comes here.");
  std::string name = shown.name;
  ImGui::SetNextItemWidth(-1);
  if (std::exchange(studio.ui.wanted_name, false)) {
    const float low = ImGui::GetCursorScreenPos().y - ImGui::GetWindowPos().y;
    const bool seen = low >= 0 && low + ImGui::GetFrameHeight() <= ImGui::GetWindowHeight();
    if (!seen) ImGui::SetScrollHereY();
    ImGui::SetWindowFocus();
    ImGui::SetKeyboardFocusHere();
  }
  ImGui::InputText("##name", &name, ImGuiInputTextFlags_AutoSelectAll);
  mark_target(studio, "field:Name");
  const bool over = ImGui::IsItemDeactivatedAfterEdit();
  // The field gives its text back only while it has the keyboard: after Tab, or a click elsewhere, what was
  // typed is that of the preview.
  if (over && name.empty())
    studio.history.cancel_preview();
  else if (over)
    rename_part(studio.history, part, name);
  else if (ImGui::IsItemEdited())
    preview_name(studio, part, name);
}

void label_row(Studio& studio, const TemplatePart& shown) {
  row_label(studio, "Label", "The number written to label files. Parts may share one: four legs, one label.");
  int label = shown.label;
  ImGui::SetNextItemWidth(86 * studio.fonts.scale);
  const bool changed = ImGui::InputInt("##label", &label, 1, 100, ImGuiInputTextFlags_AutoSelectAll);
  mark_target(studio, "field:Label");
  label = std::max(label, 0);
  if (ImGui::IsItemDeactivatedAfterEdit())
    set_part_label(studio.history, selected_parts(studio.ui), label, Stage::done);
  else if (changed)
    set_part_label(studio.history, selected_parts(studio.ui), label, Stage::live);
  ImGui::SameLine(0, 14 * studio.fonts.scale);
  bool must_exist = shown.must_exist;
  if (ImGui::Checkbox("Must exist", &must_exist))
    set_must_exist(studio.history, selected_parts(studio.ui), must_exist);
  mark_target(studio, "field:Must exist");
  tooltip("A fit without this part is no fit.");
}

void existence_row(Studio& studio, const TemplatePart& shown) {
  row_label(studio, "Existence", "The share of the shapes that have this part.");
  double percent = 100 * shown.existence;
  ImGui::SetNextItemWidth(-1);
  const double low = 0.1;
  const double high = 100;
  const bool changed = ImGui::SliderScalar("##existence", ImGuiDataType_Double, &percent, &low, &high,
                                           "%.0f %%", ImGuiSliderFlags_AlwaysClamp);
  mark_target(studio, "field:Existence");
  if (ImGui::IsItemDeactivatedAfterEdit())
    set_existence(studio.history, selected_parts(studio.ui), percent / 100, Stage::done);
  else if (changed)
    set_existence(studio.history, selected_parts(studio.ui), percent / 100, Stage::live);
}

// A swatch that opens the colours to choose from.
void colour_row(Studio& studio, const PartTemplate& part_template, std::size_t part) {
  row_label(studio, "Colour", "One of those that can be told apart without seeing red and green.");
  const float side = ImGui::GetFrameHeight();
  const auto swatch = [&](const std::string& name, const Rgb& rgb, ImVec2 size) {
    const ImVec4 colour(rgb[0] / 255.F, rgb[1] / 255.F, rgb[2] / 255.F, 1);
    const bool clicked = ImGui::ColorButton(name.c_str(), colour, ImGuiColorEditFlags_NoTooltip, size);
    mark_target(studio, "colour:" + name);
    return clicked;
  };
  if (swatch("choose", part_colour(part_template, static_cast<int>(part)), {2.2F * side, side}))
    ImGui::OpenPopup("colours");
  if (!ImGui::BeginPopup("colours")) return;
  std::optional<int> chosen;
  for (int i = 0; i < part_colour_count; ++i) {
    if (i % 7 != 0) ImGui::SameLine();
    if (swatch(std::to_string(i), part_colour(i), {side, side})) chosen = i;
  }
  if (ImGui::Selectable("By its place in the list")) chosen = -1;
  mark_target(studio, "colour:auto");
  if (chosen) {
    set_part_colour(studio.history, selected_parts(studio.ui), *chosen);
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

// What follows its edits, and how to end that.
void mirror_row(Studio& studio, const PartTemplate& part_template, std::size_t part) {
  const std::optional<std::size_t> partner = mirror_partner(part_template, part);
  if (!partner) return;
  row_label(studio, "Mirror",
            "Both are kept each other's mirror image: an edit of one is made to the other too.");
  const float button = 70 * studio.fonts.scale;
  const float room = ImGui::GetContentRegionAvail().x - button - ImGui::GetStyle().ItemSpacing.x;
  ImGui::TextUnformatted(fitted(part_template.parts[*partner].name, room).c_str());
  ImGui::SameLine(ImGui::GetContentRegionMax().x - button);
  command_button(studio, "unlink-parts", "Unlink", {button, 0});
}

void box_rows(Studio& studio, std::size_t part, const Box& box) {
  const float speed = 0.004f;  // normalised units per pixel: a drag over a panel is about the size of a shape
  vector_row(studio, "Centre",
             "Mean centre of the box, in normalised units: the samples lie 1 from the centre of the "
             "shape on average.",
             box.centre, speed, "%.3f", [&](const Vec3& centre, Stage stage) {
               Box moved = box;
               moved.centre = centre;
               set_part_box(studio.history, part, moved, stage);
             });
  vector_row(studio, "Half size", "Mean half extents along the axes of the box.", box.half_extent, speed,
             "%.3f", [&](const Vec3& half_extent, Stage stage) {
               Box sized = box;
               sized.half_extent = half_extent;
               set_part_box(studio.history, part, sized, stage);
             });
  vector_row(studio, "Rotation", "Degrees about x, then y, then z.", degrees_of_orientation(box.orientation),
             0.5f, "%.1f°", [&](const Vec3& degrees, Stage stage) {
               Box turned = box;
               turned.orientation = orientation_of_degrees(degrees);
               set_part_box(studio.history, part, turned, stage);
             });
}

}  // namespace

void draw_part_panel(Studio& studio) {
  const auto shared = studio.history.current();  // an edit may replace the template while it is being drawn
  const PartTemplate* active = shared.active_template();
  if (!active || !studio.ui.part || *studio.ui.part >= active->parts.size()) {
    if (active && !active->parts.empty()) {
      section_title(studio, "Part");
      muted_paragraph(studio,
                      "Click a part in the list, or its box in the view, to see and type its numbers.");
    }
    return;
  }
  const std::size_t part = *studio.ui.part;
  const TemplatePart& shown = active->parts[part];
  const std::size_t count = selected_parts(studio.ui).size();
  section_title(studio, count > 1 ? (std::to_string(count) + " parts").c_str() : "Part");
  if (count > 1)
    muted_paragraph(studio, ("Label, existence and spreads are set for all of them; the box is that of " +
                             shown.name + ".")
                                .c_str());
  ImGui::PushID(static_cast<int>(part));  // every field starts anew with each part
  name_row(studio, part, shown);
  label_row(studio, shown);
  existence_row(studio, shown);
  colour_row(studio, *active, part);
  mirror_row(studio, *active, part);
  box_rows(studio, part, shown.mean_box());
  const float speed = 0.002f;
  vector_row(studio, "± centre", "Standard deviation of the centre: how far it may lie elsewhere.",
             shown.position.stddev, speed, "%.3f", [&](const Vec3& stddev, Stage stage) {
               set_position_stddev(studio.history, selected_parts(studio.ui), stddev, stage);
             });
  vector_row(studio, "± size", "Standard deviation of the half extents.", shown.scale.stddev, speed, "%.3f",
             [&](const Vec3& stddev, Stage stage) {
               set_scale_stddev(studio.history, selected_parts(studio.ui), stddev, stage);
             });
  ImGui::PopID();
}

}  // namespace archetype
