// The templates of the project and the parts of the active one.
#include <imgui.h>
#include <imgui_stdlib.h>

#include "core/model/part_colours.h"
#include "core/session/actions.h"
#include "ui/icons.h"
#include "ui/panels.h"
#include "ui/project_actions.h"
#include "ui/selection.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

void draw_empty(Studio& studio) {
  muted_paragraph(
      studio,
      "A template says which parts a shape has: boxes with a mean place and size and how much each "
      "varies. Start from one that is there, or from nothing.");
  const std::vector<std::string> names = starting_templates(studio);
  const float width = share_of_width(2);
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i % 2 == 1) ImGui::SameLine();
    const std::string arguments[] = {names[i]};
    if (ImGui::Button(names[i].c_str(), {width, 0})) run_command(studio, "start-template", arguments);
    mark_target(studio, "start:" + names[i]);
  }
  command_button(studio, "suggest-templates", "Suggest some from the shapes", {share_of_width(1), 0});
  command_button(studio, "new-template", std::string(icon::plus) + "  Empty", {width, 0});
  ImGui::SameLine();
  command_button(studio, "load-template", std::string(icon::folder_open) + "  Load…", {width, 0});
}

void draw_template_menu(Studio& studio, const Document& document) {
  if (!ImGui::BeginPopup("template menu")) return;
  muted_text(studio, "Name");
  ImGui::SameLine();
  std::string name = document.active_template()->name;
  ImGui::SetNextItemWidth(180 * studio.fonts.scale);
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  ImGui::InputText("##name", &name, ImGuiInputTextFlags_AutoSelectAll);
  mark_target(studio, "field:Template name");
  if (ImGui::IsItemDeactivatedAfterEdit()) {
    if (!name.empty()) rename_active_template(studio.history, name);
    // Else the next click, on whatever it is, would do nothing but close the menu.
    const auto tapped = [](ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetIO().KeyMap[key], false); };
    if (tapped(ImGuiKey_Enter) || tapped(ImGuiKey_KeyPadEnter)) ImGui::CloseCurrentPopup();
  }
  ImGui::Separator();
  for (const char* command : {"duplicate-template", "template-up", "template-down"})
    command_menu_item(studio, *find_command(studio, command));
  if (ImGui::BeginMenu("Compare with", document.templates.size() > 1)) {
    for (std::size_t i = 0; i < document.templates.size(); ++i) {
      if (i == document.active) continue;
      const std::string other[] = {document.templates[i]->name};
      ImGui::PushID(static_cast<int>(i));
      if (ImGui::MenuItem(other[0].c_str(), nullptr, other[0] == studio.ui.compared))
        run_command(studio, "compare-template", other);
      ImGui::PopID();
      mark_target(studio, "compare:" + other[0]);
    }
    ImGui::EndMenu();
  }
  command_menu_item(studio, *find_command(studio, "stop-comparing"));
  ImGui::EndPopup();
}

void draw_part_buttons(Studio& studio) {
  const std::pair<const char*, std::string> buttons[] = {
      {"add-part", std::string(icon::plus) + " Add"},
      {"duplicate-part", "Duplicate"},
      {"mirror-part", std::string(icon::mirror) + " Mirror"},
      {"draw-box", std::string(icon::draw) + " Draw"},
      {"box-of-piece", std::string(icon::cube) + " Piece"},
      {"box-of-segment", std::string(icon::cubes) + " Segment"},
      {"split-part", std::string(icon::split) + " Split"},
      {"merge-parts", std::string(icon::merge) + " Merge"},
      {"delete-part", std::string(icon::trash) + " Delete"}};
  const int columns = share_of_width(3) < 70 * studio.fonts.scale ? 2 : 3;
  const float width = share_of_width(columns);
  int column = 0;
  for (const auto& [command, label] : buttons) {
    if (column > 0) ImGui::SameLine();
    command_button(studio, command, label, {width, 0});
    column = (column + 1) % columns;
  }
}

void draw_templates(Studio& studio, const Document& document) {
  const float buttons = 5 * (ImGui::GetFrameHeight() * 1.15f + ImGui::GetStyle().ItemSpacing.x);
  const float name_room = ImGui::GetContentRegionAvail().x - buttons;
  // A narrow panel has a line for the name alone.
  const bool own_line = name_room < 90 * studio.fonts.scale;
  ImGui::SetNextItemWidth(own_line ? -1 : name_room);
  if (ImGui::BeginCombo("##template", document.active_template()->name.c_str())) {
    for (std::size_t i = 0; i < document.templates.size(); ++i) {
      ImGui::PushID(static_cast<int>(i));
      if (ImGui::Selectable(document.templates[i]->name.c_str(), i == document.active)) {
        select_template(studio.history, i);
        select_only(studio.ui, std::nullopt);
      }
      mark_target(studio, "template:" + std::to_string(i));
      ImGui::PopID();
    }
    ImGui::EndCombo();
  }
  mark_target(studio, "template:choose");
  const ImVec2 size(ImGui::GetFrameHeight() * 1.15f, 0);
  if (!own_line) ImGui::SameLine();
  command_button(studio, "new-template", icon::plus, size);
  ImGui::SameLine();
  command_button(studio, "load-template", icon::folder_open, size);
  ImGui::SameLine();
  command_button(studio, "save-template", icon::save, size);
  ImGui::SameLine();
  command_button(studio, "delete-template", icon::trash, size);
  ImGui::SameLine();
  if (sized_button(icon::more, size)) ImGui::OpenPopup("template menu");
  mark_target(studio, "template:more");
  tooltip("Rename, duplicate, reorder, compare");
  draw_template_menu(studio, document);
}

void select_in_list(Studio& studio, std::size_t part) {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.KeyShift)
    select_up_to(studio.ui, part);
  else if (io.KeyCtrl)
    toggle_selected(studio.ui, part);
  else
    select_only(studio.ui, part);
}

void draw_part_row(Studio& studio, const PartTemplate& part_template, std::size_t index) {
  const TemplatePart& part = part_template.parts[index];
  const Rgb rgb = part_colour(part_template, static_cast<int>(index));
  ImGui::PushID(static_cast<int>(index));
  const ImVec2 low = ImGui::GetCursorScreenPos();
  if (ImGui::Selectable("##part", is_selected(studio.ui, index))) select_in_list(studio, index);
  mark_target(studio, "part:" + part.name);
  const float line = ImGui::GetTextLineHeight();
  const float side = line * 0.72f;
  const ImVec2 swatch(low.x + 4 * studio.fonts.scale, low.y + (line - side) / 2);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(swatch, {swatch.x + side, swatch.y + side}, IM_COL32(rgb[0], rgb[1], rgb[2], 255),
                      3 * studio.fonts.scale);
  const float right = low.x + ImGui::GetContentRegionAvail().x;
  const float text_x = swatch.x + side + 8 * studio.fonts.scale;
  const std::string facts = (part.mirror.pair > 0 ? "mirrored  ·  " : "") +
                            std::string(part.must_exist ? "must exist  ·  " : "") + "label " +
                            std::to_string(part.label);
  ImGui::PushFont(studio.fonts.small);
  const float facts_width = ImGui::CalcTextSize(facts.c_str()).x;
  draw->AddText({right - facts_width - 4 * studio.fonts.scale, low.y + 1 * studio.fonts.scale},
                ImGui::GetColorU32(colours(studio).muted), facts.c_str());
  ImGui::PopFont();
  const std::string name = fitted(part.name, right - facts_width - text_x - 12 * studio.fonts.scale);
  draw->AddText({text_x, low.y}, ImGui::GetColorU32(ImGuiCol_Text), name.c_str());
  ImGui::PopID();
}

}  // namespace

void draw_template_panel(Studio& studio) {
  section_title(studio, "Template");
  const Document document = studio.history.current();  // a click may change it while it is being drawn
  const PartTemplate* active = document.active_template();
  if (!active) {
    draw_empty(studio);
    return;
  }
  draw_templates(studio, document);
  if (active->parts.empty())
    muted_paragraph(studio, "No parts yet: add a box, then move and size it over the shape.");
  for (std::size_t i = 0; i < active->parts.size(); ++i) draw_part_row(studio, *active, i);
  draw_part_buttons(studio);
}

}  // namespace archetype
