// On the left what a shape is (template, status, parts), on the right histograms of its numbers to drag over.
#include "ui/filter_panel.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/session/cluster_size.h"
#include "ui/histogram_plot.h"
#include "ui/icons.h"
#include "ui/order_menu.h"
#include "ui/panels.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

// Small buttons that are on or off, after a word for what they are; they flow from line to line.
class Chips {
 public:
  Chips(Studio& studio, const char* heading)
      : studio_(studio), right_(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x) {
    ImGui::AlignTextToFramePadding();
    muted_text(studio, heading);
  }

  bool chip(const std::string& target, const std::string& text, bool on) {
    const float room = ImGui::GetContentRegionMax().x - 2 * ImGui::GetStyle().FramePadding.x;
    const std::string shown = fitted(text, room);
    const float width = ImGui::CalcTextSize(shown.c_str()).x + 2 * ImGui::GetStyle().FramePadding.x;
    ImGui::SameLine();
    if (ImGui::GetCursorPosX() + width > right_) ImGui::NewLine();
    const Palette& p = colours(studio_);
    ImGui::PushStyleColor(ImGuiCol_Button, on ? ImVec4(p.accent.x, p.accent.y, p.accent.z, 0.30f) : p.raised);
    ImGui::PushStyleColor(ImGuiCol_Text, on ? p.text : p.muted);
    const bool clicked = ImGui::Button((shown + "###" + target).c_str());
    ImGui::PopStyleColor(2);
    mark_target(studio_, target);
    return clicked;
  }

 private:
  Studio& studio_;
  float right_;
};

std::size_t count_rows(const Studio& studio, const auto& condition) {
  return static_cast<std::size_t>(std::ranges::count_if(studio.collection.rows(), condition));
}

void draw_templates(Studio& studio, const FitTable& table) {
  Chips chips(studio, "Template");
  auto& hidden = studio.ui.shown.filter.hidden_templates;
  for (const TemplateRecord& record : table.templates) {
    ClusterSize size;
    for (const ShapeRow& row : studio.collection.rows())
      if (row.fit && row.fit->part_template == record.id) size.add(row.fit->status);
    const bool on = std::ranges::find(hidden, record.id) == hidden.end();
    const std::string target = "filter-template:" + std::to_string(record.id);
    if (chips.chip(target, record.part_template.name + "  ·  " + to_string(size), on))
      toggle_hidden(hidden, record.id);
    tooltip(on ? "Shown: click to hide its shapes" : "Hidden: click to show its shapes");
  }
}

void draw_statuses(Studio& studio) {
  Chips chips(studio, "Status");
  ShapeFilter& filter = studio.ui.shown.filter;
  constexpr std::array statuses{std::pair(FitStatus::learned, "learned from"),
                                std::pair(FitStatus::fitted, "fitted"),
                                std::pair(FitStatus::outlier, "outlier")};
  for (const auto& [status, name] : statuses) {
    const std::size_t count = count_rows(
        studio, [&, wanted = status](const ShapeRow& row) { return row.fit && row.fit->status == wanted; });
    const bool on = std::ranges::find(filter.hidden_statuses, status) == filter.hidden_statuses.end();
    if (count == 0 && on) continue;
    if (chips.chip("filter-status:" + std::string(to_string(status)),
                   std::string(name) + "  ·  " + count_text(count), on))
      toggle_hidden(filter.hidden_statuses, status);
  }
  const std::size_t unfitted = count_rows(studio, [](const ShapeRow& row) { return !row.fit; });
  if (unfitted == 0 && !filter.hide_unfitted) return;
  if (chips.chip("filter-status:none", "without a fit  ·  " + count_text(unfitted), !filter.hide_unfitted))
    filter.hide_unfitted = !filter.hide_unfitted;
}

// Each condition turns from "has" to "lacks" and goes with the third click.
void draw_parts(Studio& studio, const FitTable& table) {
  Chips chips(studio, "Parts");
  auto& conditions = studio.ui.shown.filter.parts;
  std::optional<std::size_t> over;
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    const std::string text = (conditions[i].present ? "has " : "lacks ") + conditions[i].part;
    if (!chips.chip("filter-part:" + conditions[i].part, text, true)) continue;
    if (conditions[i].present)
      conditions[i].present = false;
    else
      over = i;
  }
  if (over) conditions.erase(conditions.begin() + static_cast<std::ptrdiff_t>(*over));
  if (chips.chip("filter-part-add", std::string(icon::plus) + "  Part", false)) ImGui::OpenPopup("parts");
  if (!ImGui::BeginPopup("parts")) return;
  for (const std::string& part : part_names(table)) {
    const auto known = std::ranges::find(conditions, part, &PartCondition::part);
    if (ImGui::MenuItem(part.c_str(), known == conditions.end() ? nullptr
                                      : known->present          ? "has"
                                                                : "lacks")) {
      if (known == conditions.end())
        conditions.push_back({part, true});
      else
        known->present = !known->present;
    }
    mark_target(studio, "filter-add:" + part);
  }
  ImGui::EndPopup();
}

void draw_kinds(Studio& studio, const FitTable* table) {
  if (table && !table->templates.empty()) draw_templates(studio, *table);
  draw_statuses(studio);
  if (table && !table->templates.empty()) draw_parts(studio, *table);
}

std::string range_text(const PlottedHistogram& plotted) {
  if (!plotted.range) return plotted_number(plotted.all->low) + " to " + plotted_number(plotted.all->high);
  const auto [low, high] = *plotted.range;
  if (std::isinf(low)) return "at most " + plotted_number(high);
  if (std::isinf(high)) return "at least " + plotted_number(low);
  return "kept: " + plotted_number(low) + " to " + plotted_number(high);
}

// The name is a button: another column, or none.
bool draw_histogram_title(Studio& studio, ShownHistogram& each, std::size_t place, float width) {
  bool removed = false;
  const std::string target = "histogram-title:" + std::to_string(place);
  const std::string title = column_title(each.column, studio.collection.rows());
  const float room = width - 2 * ImGui::GetStyle().FramePadding.x;
  if (ImGui::Button((fitted(title, room) + "###title").c_str(), {width, 0})) ImGui::OpenPopup("column");
  mark_target(studio, target);
  tooltip((title + "\nClick to show something else").c_str());
  if (!ImGui::BeginPopup("column")) return false;
  ShapeFilter& filter = studio.ui.shown.filter;
  if (const auto column = draw_column_items(studio, &each.column, false)) {
    clear_range(filter, each.column);
    each = {*column};
    studio.ui.shown.histograms_chosen = true;
  }
  ImGui::Separator();
  if (ImGui::MenuItem("Sort by it")) studio.ui.shown.order = {each.column, descending_at_first(each.column)};
  mark_target(studio, target + ":sort");
  if (ImGui::MenuItem("Remove")) removed = true;
  mark_target(studio, target + ":remove");
  ImGui::EndPopup();
  return removed;
}

// Whether it is to be removed.
bool draw_one(Studio& studio, ShownHistogram& each, std::size_t place, float width, float height) {
  ShapeFilter& filter = studio.ui.shown.filter;
  ImGui::PushID(static_cast<int>(place));
  ImGui::BeginGroup();
  const bool removed = draw_histogram_title(studio, each, place, width);
  if (!each.all.counts.empty()) {
    PlottedHistogram plotted{&each.all, &each.shown, std::nullopt};
    if (const ValueRange* range = find_range(filter, each.column)) plotted.range = {range->low, range->high};
    const float bars = height - ImGui::GetFrameHeightWithSpacing() - ImGui::GetTextLineHeightWithSpacing();
    std::pair<double, double> range;
    const std::string target = "histogram:" + std::to_string(place);
    const Brushed brushed = draw_histogram(studio, target, plotted, {width, bars}, range);
    if (brushed == Brushed::changed) set_range(filter, each.column, range.first, range.second);
    if (brushed == Brushed::cleared) clear_range(filter, each.column);
    ImGui::PushFont(studio.fonts.small);
    const std::string text = each.all.total == 0 ? "no shape has it" : range_text(plotted);
    if (plotted.range)
      ImGui::TextUnformatted(text.c_str());
    else
      muted_text(studio, text);
    ImGui::PopFont();
  }
  ImGui::EndGroup();
  ImGui::PopID();
  return removed;
}

void draw_histograms(Studio& studio) {
  follow_histograms(studio);
  ShownShapes& shown = studio.ui.shown;
  const float width = 190 * studio.fonts.scale;
  const float height =
      std::max(ImGui::GetContentRegionAvail().y - ImGui::GetStyle().ScrollbarSize, 90 * studio.fonts.scale);
  std::optional<std::size_t> removed;
  for (std::size_t i = 0; i < shown.histograms.size(); ++i) {
    if (draw_one(studio, shown.histograms[i], i, width, height)) removed = i;
    ImGui::SameLine(0, 12 * studio.fonts.scale);
  }
  if (removed) {
    clear_range(shown.filter, shown.histograms[*removed].column);
    shown.histograms.erase(shown.histograms.begin() + static_cast<std::ptrdiff_t>(*removed));
    shown.histograms_chosen = true;
  }
  if (ImGui::Button((std::string(icon::plus) + "  Histogram").c_str())) ImGui::OpenPopup("add");
  mark_target(studio, "histogram-add");
  if (!ImGui::BeginPopup("add")) return;
  if (const auto column = draw_column_items(studio, nullptr, false)) {
    shown.histograms.push_back({*column});
    shown.histograms_chosen = true;
  }
  ImGui::EndPopup();
}

}  // namespace

void draw_filter_button(Studio& studio, float width) {
  const std::size_t conditions = condition_count(studio.ui.shown.filter);
  if (conditions > 0) {
    const ImVec4 accent = colours(studio).accent;
    ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(accent.x, accent.y, accent.z, 0.45f));
  }
  command_button(studio, "show-filter", icon::filter, {width, 0});
  if (conditions > 0) ImGui::PopStyleColor();
}

void draw_filter_panel(Studio& studio) {
  if (studio.collection.rows().empty()) {
    empty_hint(studio, "Nothing to filter yet", "Open a folder of shapes first.");
    return;
  }
  const std::shared_ptr<const FitTable> table = use_fit_table(studio);
  const std::size_t shown = shown_rows(studio).size();
  const float left = std::min(300 * studio.fonts.scale, ImGui::GetContentRegionAvail().x * 0.4f);
  ImGui::BeginChild("##kinds", {left, 0});
  const std::string count =
      count_text(shown) + " of " + count_text(studio.collection.rows().size()) + " shapes";
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(count.c_str());
  ImGui::SameLine();
  command_button(studio, "clear-filter", "Show all");
  draw_kinds(studio, table.get());
  ImGui::EndChild();
  ImGui::SameLine(0, 16 * studio.fonts.scale);
  ImGui::BeginChild("##histograms", {0, 0}, false, ImGuiWindowFlags_HorizontalScrollbar);
  draw_histograms(studio);
  ImGui::EndChild();
}

void show_filter(Studio& studio) {
  studio.settings.show_bottom = true;
  studio.ui.wanted_bottom_tab = BottomTab::filter;
}

}  // namespace archetype
