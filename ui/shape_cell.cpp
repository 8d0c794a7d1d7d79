#include "ui/shape_cell.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "ui/icons.h"
#include "ui/part_highlight.h"
#include "ui/picked_place.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

// The picture, or a quiet sign until it has been made.
void draw_picture(Studio& studio, const ShapeRow& row, ImVec2 low, float side) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImVec2 high(low.x + side, low.y + side);
  if (const std::uint32_t texture = studio.thumbnails.use(shown_thumbnail(studio, row))) {
    // Rows of pictures run from the top, as Dear ImGui's textures do.
    draw->AddImage(reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(texture)), low, high);
    return;
  }
  const ImVec4 muted = colours(studio).muted;
  const ImVec2 size = ImGui::CalcTextSize(icon::cube);
  draw->AddText({low.x + (side - size.x) / 2, low.y + (side - size.y) / 2},
                ImGui::GetColorU32({muted.x, muted.y, muted.z, 0.4f}), icon::cube);
}

void draw_caption(Studio& studio, const ShapeRow& row, const std::string& note, ImVec2 low, ImVec2 high,
                  bool bright) {
  const Palette& p = colours(studio);
  const float scale = studio.fonts.scale;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  ImGui::PushFont(studio.fonts.small);
  const float room = high.x - low.x - 10 * scale;
  const float y = high.y - ImGui::GetTextLineHeight() - 4 * scale;
  const float note_width = note.empty() ? 0 : ImGui::CalcTextSize(note.c_str()).x + 6 * scale;
  const std::string name = fitted(row.name, room - note_width);
  const float name_width = ImGui::CalcTextSize(name.c_str()).x;
  const float x = note.empty() ? low.x + (high.x - low.x - name_width) / 2 : low.x + 5 * scale;
  draw->AddText({x, y}, ImGui::GetColorU32(bright ? p.text : p.muted), name.c_str());
  if (!note.empty())
    draw->AddText({high.x - note_width + 1 * scale, y}, ImGui::GetColorU32(p.text), note.c_str());
  ImGui::PopFont();
}

void draw_frame_of(const Studio& studio, const ShapeRow& row, ImVec2 low, ImVec2 high, bool hovered) {
  const Palette& p = colours(studio);
  const ExplorerSelection& selection = studio.ui.selection;
  const bool in_view = studio.ui.shape == row.id;
  const bool selected = is_selected(selection, row.id);
  const float scale = studio.fonts.scale;
  const float rounding = 6 * scale;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(low, high, ImGui::GetColorU32(hovered || in_view || selected ? p.hovered : p.raised),
                      rounding);
  if (selected)
    draw->AddRectFilled(low, high, ImGui::GetColorU32({p.accent.x, p.accent.y, p.accent.z, 0.22f}), rounding);
}

void draw_outline_of(const Studio& studio, const ShapeRow& row, ImVec2 low, ImVec2 high) {
  const Palette& p = colours(studio);
  const float scale = studio.fonts.scale;
  const bool in_view = studio.ui.shape == row.id;
  if (!in_view && !is_selected(studio.ui.selection, row.id)) return;
  const ImVec4 colour(p.accent.x, p.accent.y, p.accent.z, in_view ? 1.0f : 0.6f);
  ImGui::GetWindowDrawList()->AddRect(low, high, ImGui::GetColorU32(colour), 6 * scale, 0,
                                      (in_view ? 2.0f : 1.5f) * scale);
}

void tell(Studio& studio, const ShapeRow& row) {
  std::string text = row.name + "\n" + count_text(row.element_count) + " faces or points";
  if (row.fit) {
    char energy[96];
    std::snprintf(energy, sizeof energy, "\nfit: energy %.3f, yaw %d°, %s", row.fit->energy.total(),
                  row.fit->yaw_quarters * 90, std::string(to_string(row.fit->status)).c_str());
    text += energy;
  } else {
    text += "\nnot fitted yet";
  }
  ImGui::SetTooltip("%s", text.c_str());
  studio.ui.selection.hovering = row.id;
}

// What else can be done with a shape; those that are there.
constexpr std::array shape_commands{"show-inspect", "template-from-shape", "mark-outlier", "learn-from-shape",
                                    "strip-add"};

// Some take the name of a shape, and some are of the shape in view.
void run_on_shape(Studio& studio, const Command& command, const ShapeRow& row) {
  const std::string arguments[] = {row.name};
  if (command.arguments.empty()) {
    select_only(studio.ui.selection, {row.id});
    show_shape(studio, row.id);
    run_command(studio, command.name);
  } else {
    run_command(studio, command.name, arguments);
  }
}

void draw_menu(Studio& studio, const ShapeRow& row) {
  if (ImGui::MenuItem("Open", "double click")) open_shape(studio, row.id);
  mark_target(studio, "shape-menu:open");
  if (ImGui::MenuItem("Sort by similarity to it", nullptr, false, row.fit.has_value()))
    studio.ui.shown.order = {{.quantity = ShapeQuantity::similarity, .shape = row.id}, false};
  mark_target(studio, "shape-menu:similar");
  if (ImGui::MenuItem("Select its whole cluster", nullptr, false, row.fit.has_value())) {
    std::vector<ShapeId> members;
    for (const std::size_t i : shown_rows(studio)) {
      const ShapeRow& other = studio.collection.rows()[i];
      if (other.fit && row.fit && other.fit->part_template == row.fit->part_template)
        members.push_back(other.id);
    }
    select_only(studio.ui.selection, std::move(members));
  }
  mark_target(studio, "shape-menu:cluster");
  ImGui::Separator();
  for (const char* name : shape_commands) {
    const Command* command = find_command(studio, name);
    if (!command) continue;
    if (ImGui::MenuItem(std::string(command->title).c_str())) run_on_shape(studio, *command, row);
    mark_target(studio, std::string("shape-menu:") + name);
  }
}

CellClick click_kind() {
  const ImGuiIO& io = ImGui::GetIO();
  return io.KeyShift ? CellClick::extend : io.KeyCtrl ? CellClick::toggle : CellClick::only;
}

// Over the upper right corner of the picture. Whether it was clicked.
bool draw_template_button(Studio& studio, const ShapeRow& row, ImVec2 low, ImVec2 high) {
  const float side = ImGui::GetTextLineHeight() + 6 * studio.fonts.scale;
  const ImVec2 after = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos({high.x - side - 3 * studio.fonts.scale, low.y + 3 * studio.fonts.scale});
  const bool clicked = ImGui::Button(icon::plus, {side, side});
  mark_target(studio, "make-template:" + row.name);
  tooltip("Make a template from this shape");
  ImGui::SetCursorScreenPos(after);
  return clicked;
}

}  // namespace

WantedThumbnail shown_thumbnail(Studio& studio, const ShapeRow& row) {
  WantedThumbnail wanted = wanted_thumbnail(row);
  const ExplorerSelection& selection = studio.ui.selection;
  if (!selection.part || !row.fit) return wanted;
  if (studio.ui.centre == CentreView::shape && !highlights_in_shape_view(studio)) return wanted;
  const std::shared_ptr<const FitTable> table = use_fit_table(studio);
  if (!table) return wanted;
  const auto mine = std::ranges::find(table->templates, row.fit->part_template, &TemplateRecord::id);
  if (mine == table->templates.end()) return wanted;
  const auto same = highlighted_part(studio, mine->part_template);
  wanted.highlighted = same ? static_cast<int>(*same) : no_such_part;
  if (same && selection.place && selection.place->on == *selection.part)
    wanted.place = place_in(*table, *selection.place, mine->part_template, *same);
  return wanted;
}

CellClick draw_shape_cell(Studio& studio, const ShapeRow& row, const ShapeCell& cell) {
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const ImVec2 high(low.x + cell.size.x, low.y + cell.size.y);
  ImGui::PushID(static_cast<int>(row.id));
  const bool pressed = ImGui::InvisibleButton("cell", cell.size);
  ImGui::SetItemAllowOverlap();
  mark_target(studio, cell.target + ":" + row.name);
  const bool under_mouse = ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenOverlapped);
  // Also while the button over the picture is held down.
  const bool offered =
      cell.offers_template && ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenOverlapped |
                                                   ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
  CellClick click = pressed ? click_kind() : CellClick::none;
  if (under_mouse && ImGui::IsMouseDoubleClicked(0) && click_kind() == CellClick::only)
    click = CellClick::open;
  const bool hovered = under_mouse || studio.ui.selection.hovered == row.id;
  draw_frame_of(studio, row, low, high, hovered);
  draw_picture(studio, row, low, cell.size.x);
  draw_caption(studio, row, cell.note, low, high, studio.ui.shape == row.id);
  draw_outline_of(studio, row, low, high);
  if (ImGui::BeginPopupContextItem("menu")) {
    draw_menu(studio, row);
    ImGui::EndPopup();
  } else if (under_mouse) {
    tell(studio, row);
  }
  if (offered && draw_template_button(studio, row, low, high)) {
    if (const Command* command = find_command(studio, "template-from-shape"))
      run_on_shape(studio, *command, row);
    click = CellClick::none;
  }
  ImGui::PopID();
  return click;
}

std::vector<ShapeId> range_of(const std::vector<ShapeId>& order, std::optional<ShapeId> from, ShapeId to) {
  const auto end = std::ranges::find(order, to);
  auto begin = from ? std::ranges::find(order, *from) : order.end();
  if (end == order.end() || begin == order.end()) return {to};
  return begin < end ? std::vector(begin, end + 1) : std::vector(end, begin + 1);
}

void take_click(Studio& studio, CellClick click, ShapeId shape, const std::vector<ShapeId>& order) {
  ExplorerSelection& selection = studio.ui.selection;
  switch (click) {
    case CellClick::none:
      return;
    case CellClick::only:
      select_only(selection, {shape});
      show_shape(studio, shape);
      return;
    case CellClick::toggle:
      toggle_selected(selection, shape);
      return;
    case CellClick::extend:
      add_to_selection(selection, range_of(order, studio.ui.shape, shape));
      return;
    case CellClick::open:
      open_shape(studio, shape);
      return;
  }
}

void open_shape(Studio& studio, ShapeId shape) {
  select_only(studio.ui.selection, {shape});
  show_shape(studio, shape);
  studio.ui.grid.scroll_to_shape = true;
  studio.ui.centre = CentreView::shape;
  const std::optional<std::size_t> row = find_row(studio.collection, shape);
  const std::shared_ptr<const FitTable> table = use_fit_table(studio);
  if (!row || !table || !studio.collection.rows()[*row].fit) return;
  const auto record = std::ranges::find(table->templates, studio.collection.rows()[*row].fit->part_template,
                                        &TemplateRecord::id);
  if (record == table->templates.end()) return;
  const PartTemplate* active = studio.history.current().active_template();
  if (active && *active == record->part_template)
    stop_looking(studio);
  else
    look_at(studio, record->part_template, "its cluster");
}

}  // namespace archetype
