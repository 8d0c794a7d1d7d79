// Sliders for the parameters of a part: what a cluster varies in, and the shapes that are so (figure 9).
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstdio>

#include "core/base/error.h"
#include "ui/command_groups.h"
#include "ui/icons.h"
#include "ui/plot_sources.h"
#include "ui/shape_cell.h"
#include "ui/shape_map_view.h"
#include "ui/studio.h"
#include "ui/template_picture.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

constexpr std::size_t most_nearest = 12;
constexpr float farthest = 3;  // deviations that a slider reaches

struct Slider {
  const char* name;   // for scripts
  const char* label;  // for people
};
constexpr std::array<Slider, part_parameter_count> sliders{{{"x", "sideways"},
                                                            {"y", "up, down"},
                                                            {"z", "to the front"},
                                                            {"width", "width"},
                                                            {"height", "height"},
                                                            {"depth", "depth"}}};

// What is wished belongs to one template: of another one all begins anew.
void follow_template(SliderState& state, const TemplateRecord& record) {
  if (state.of != record.id || state.wishes.size() != record.part_template.parts.size()) {
    state.of = record.id;
    state.wishes.assign(record.part_template.parts.size(), PartWish{});
  }
}

constexpr std::size_t bins = 25;
using Spread = std::array<std::array<std::size_t, bins>, part_parameter_count>;

// How the fitted values of a part are spread. A fraction of a millisecond for 10,000 shapes.
Spread spread_of(const FitTable& table, std::size_t part_template, std::size_t part) {
  Spread counts{};
  const TemplatePart& of = table.templates[part_template].part_template.parts[part];
  for (const FitTableRow& row : table.rows) {
    if (row.part_template != part_template) continue;
    const PartValues& values = table.parts_of(row)[part];
    if (!values.present) continue;
    const auto parameters = part_parameters(of, values.box);
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      const double share = (parameters[i] + farthest) / (2 * farthest);
      if (share >= 0 && share < 1) ++counts[i][static_cast<std::size_t>(share * bins)];
    }
  }
  return counts;
}

// As bars behind a slider.
void draw_spread(const std::array<std::size_t, bins>& counts, ImVec2 low, ImVec2 high, ImU32 colour) {
  const auto most = static_cast<float>(std::max<std::size_t>(1, *std::ranges::max_element(counts)));
  const float width = (high.x - low.x) / bins;
  for (std::size_t i = 0; i < bins; ++i) {
    const float x = low.x + width * static_cast<float>(i);
    const float top = high.y - (high.y - low.y) * static_cast<float>(counts[i]) / most;
    if (counts[i] > 0) ImGui::GetWindowDrawList()->AddRectFilled({x, top}, {x + width - 1, high.y}, colour);
  }
}

void draw_slider(Studio& studio, const Spread& spread, std::size_t part, std::size_t parameter) {
  std::optional<double>& wish = studio.ui.map.slider.wishes[part][parameter];
  const float scale = studio.fonts.scale;
  const Palette& p = colours(studio);
  ImGui::PushID(static_cast<int>(parameter));
  const float label = 82 * scale;
  const float reset = ImGui::GetFrameHeight();
  const float width = ImGui::GetContentRegionAvail().x - label - reset - 8 * scale;
  const ImVec2 low = ImGui::GetCursorScreenPos();
  ImGui::AlignTextToFramePadding();
  ImGui::TextColored(wish ? p.text : p.muted, "%s", sliders[parameter].label);
  ImGui::SameLine(label);
  ImGui::SetNextItemWidth(width);
  const ImVec2 bar(ImGui::GetCursorScreenPos().x, low.y);
  auto value = static_cast<float>(wish.value_or(0));
  ImGui::PushStyleColor(ImGuiCol_FrameBg, ImVec4(p.raised.x, p.raised.y, p.raised.z, 0.6f));
  // Where any will do there is nothing to hold, and the word is to be read.
  ImGui::PushStyleColor(ImGuiCol_SliderGrab, ImVec4(p.accent.x, p.accent.y, p.accent.z, wish ? 1 : 0.3f));
  if (ImGui::SliderFloat("##wish", &value, -farthest, farthest, wish ? "%+.1f σ" : "any")) wish = value;
  ImGui::PopStyleColor(2);
  mark_target(studio, "wish:" + std::to_string(parameter));
  if (!ImGui::IsItemActive())
    draw_spread(spread[parameter], bar, {bar.x + width, bar.y + ImGui::GetFrameHeight()},
                ImGui::GetColorU32({p.accent.x, p.accent.y, p.accent.z, 0.28f}));
  tooltip("In standard deviations of the template from its mean. The bars show what its shapes have.");
  ImGui::SameLine(0, 4 * scale);
  if (wish) {
    if (ImGui::Button(icon::close, {reset, 0})) wish.reset();
    mark_target(studio, "wish:any:" + std::to_string(parameter));
    tooltip("Any");
  } else {
    ImGui::Dummy({reset, 1});
  }
  ImGui::PopID();
}

void draw_near_shape(Studio& studio, const NearShape& near, float side) {
  const ShapeRow* row = map_row(studio, near.shape);
  if (!row) return;
  const Palette& p = colours(studio);
  const float rounding = 5 * studio.fonts.scale;
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const ImVec2 high(low.x + side, low.y + side);
  ImGui::PushID(static_cast<int>(near.shape));
  if (ImGui::InvisibleButton("near", {side, side})) {
    select_only(studio.ui.selection, {near.shape});
    show_shape(studio, near.shape);
    studio.ui.grid.scroll_to_shape = true;
  }
  ImGui::PopID();
  mark_target(studio, "near:" + row->name);
  const bool hovered = ImGui::IsItemHovered();
  if (hovered) studio.ui.selection.hovering = near.shape;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(low, high, ImGui::GetColorU32(hovered ? p.hovered : p.raised), rounding);
  if (const std::uint32_t texture = studio.thumbnails.use(shown_thumbnail(studio, *row)))
    draw.AddImageRounded(reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(texture)), low, high,
                         {0, 0}, {1, 1}, IM_COL32_WHITE, rounding);
  if (is_selected(studio.ui.selection, near.shape) || studio.ui.selection.hovered == near.shape)
    draw.AddRect(low, high, ImGui::GetColorU32(p.accent), rounding, 0, 2 * studio.fonts.scale);
  char text[96];
  std::snprintf(text, sizeof text, "%.2f σ away on average", near.distance);
  tooltip((row->name + "\n" + text).c_str());
}

}  // namespace

std::span<const NearShape> use_nearest(Studio& studio, const std::shared_ptr<const FitTable>& table) {
  SliderState& state = studio.ui.map.slider;
  const auto chosen = template_in_focus(studio, *table);
  if (!chosen) return {};
  const bool other = state.of != table->templates[*chosen].id;
  follow_template(state, table->templates[*chosen]);
  if (other || state.found_in != table || state.found_for != state.wishes) {
    state.nearest = nearest_shapes(*table, *chosen, state.wishes, most_nearest);
    state.found_in = table;
    state.found_for = state.wishes;
  }
  return state.nearest;
}

void draw_sliders(Studio& studio, const FitTable& table) {
  const auto chosen = template_in_focus(studio, table);
  if (!chosen || table.templates[*chosen].part_template.parts.empty()) return;
  const PartTemplate& part_template = table.templates[*chosen].part_template;
  SliderState& state = studio.ui.map.slider;
  follow_template(state, table.templates[*chosen]);
  const float scale = studio.fonts.scale;
  const float room = ImGui::GetContentRegionAvail().x;
  section_title(studio, "Find by its parts");
  const float reset = 60 * scale;
  choose_template(studio, table, *chosen, room - reset - 6 * scale);
  ImGui::SameLine(0, 6 * scale);
  ImGui::BeginDisabled(std::ranges::all_of(state.wishes, is_any));
  if (ImGui::Button("Reset", {reset, 0})) state.wishes.assign(state.wishes.size(), PartWish{});
  ImGui::EndDisabled();
  mark_target(studio, "wish:reset");
  tooltip("Wish for nothing");
  const float side = std::min(room, 130 * scale);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  draw_template_picture(*ImGui::GetWindowDrawList(), wished_template(part_template, state.wishes),
                        {low.x + (room - side) / 2, low.y}, side);
  ImGui::Dummy({room, side});
  choose_part(studio, table, *chosen, room);
  const std::size_t part = part_in_focus(studio, table, *chosen);
  const Spread spread = spread_of(table, *chosen, part);
  for (std::size_t i = 0; i < part_parameter_count; ++i) {
    if (i % 3 == 0) muted_text(studio, i == 0 ? "Where it is" : "How large it is");
    draw_slider(studio, spread, part, i);
  }
}

void draw_nearest(Studio& studio) {
  const float gap = 5 * studio.fonts.scale;
  const bool any = std::ranges::all_of(studio.ui.map.slider.wishes, is_any);
  muted_text(studio, any ? "Nearest to the average of the template" : "Nearest to what is wished");
  const float side = std::floor(ImGui::GetContentRegionAvail().y);
  const std::vector<NearShape> nearest = studio.ui.map.slider.nearest;
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    if (i > 0) ImGui::SameLine(0, gap);
    if (ImGui::GetContentRegionAvail().x < side) break;
    draw_near_shape(studio, nearest[i], side);
  }
}

void wish_command(Studio& studio, Arguments arguments) {
  const auto& made = studio.shape_map.newest;
  if (!made) throw Error("show the map first");
  const auto chosen = template_in_focus(studio, *made->table);
  if (!chosen || arguments.size() != 3)
    throw Error("expected a part, a parameter and standard deviations or \"any\"");
  const TemplateRecord& record = made->table->templates[*chosen];
  const auto& parts = record.part_template.parts;
  const auto part = std::ranges::find(parts, arguments[0], &TemplatePart::name);
  if (part == parts.end()) throw Error("the template has no part \"" + arguments[0] + "\"");
  const auto slider =
      std::ranges::find_if(sliders, [&](const Slider& each) { return each.name == arguments[1]; });
  if (slider == sliders.end()) throw Error("expected x, y, z, width, height or depth");
  SliderState& state = studio.ui.map.slider;
  follow_template(state, record);
  const auto index = static_cast<std::size_t>(part - parts.begin());
  std::optional<double>& wish = state.wishes[index][static_cast<std::size_t>(slider - sliders.begin())];
  studio.ui.selection.part = PartOfTemplate{record.id, index};
  if (arguments[2] == "any")
    wish.reset();
  else
    wish = std::clamp(number_argument(arguments, 2, "standard deviations"), -100.0, 100.0);
}

}  // namespace archetype
