#include "ui/widgets.h"

#include <algorithm>
#include <cmath>

#include "ui/studio.h"

namespace archetype {
namespace {

std::string hint(const Studio& studio, const Command& command, const std::string& reason) {
  std::string text(command.title);
  if (const std::string key = key_of(studio, command); !key.empty()) text += "   " + key;
  if (!reason.empty()) text += "\nNot now: " + reason;
  return text;
}

}  // namespace

void mark_target(Studio& studio, std::string name) {
  const ImVec2 low = ImGui::GetItemRectMin();
  const ImVec2 high = ImGui::GetItemRectMax();
  studio.targets.push_back({std::move(name), low.x, low.y, high.x, high.y});
}

bool sized_button(const char* label, ImVec2 size) {
  const ImVec2 padding = ImGui::GetStyle().FramePadding;
  const float room = std::max(0.0F, (size.x - ImGui::CalcTextSize(label, nullptr, true).x) / 2);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                      {size.x > 0 ? std::min(padding.x, std::floor(room)) : padding.x, padding.y});
  const bool pressed = ImGui::Button(label, size);
  ImGui::PopStyleVar();
  return pressed;
}

bool command_button(Studio& studio, std::string_view name, const std::string& label, ImVec2 size) {
  const Command* command = find_command(studio, name);
  if (!command) return false;
  const std::string reason = why_not(studio, *command);
  ImGui::PushID(command->name.data(), command->name.data() + command->name.size());
  ImGui::BeginDisabled(!reason.empty());
  const bool pressed = sized_button(label.c_str(), size);
  ImGui::EndDisabled();
  mark_target(studio, "command:" + std::string(name));
  tooltip(hint(studio, *command, reason).c_str());
  ImGui::PopID();
  if (pressed) run_command(studio, name);
  return pressed;
}

bool command_toggle(Studio& studio, std::string_view name, const std::string& label) {
  const Command* command = find_command(studio, name);
  const bool on = command && command->checked && command->checked(studio);
  const Palette& p = colours(studio);
  if (on) {
    ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(p.accent.x, p.accent.y, p.accent.z, 0.30f));
    ImGui::PushStyleColor(ImGuiCol_Text, p.text);
  } else {
    ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0, 0, 0, 0));
    ImGui::PushStyleColor(ImGuiCol_Text, p.muted);
  }
  const bool pressed = command_button(studio, name, label);
  ImGui::PopStyleColor(2);
  return pressed;
}

void command_menu_item(Studio& studio, const Command& command) {
  if (command.separator) ImGui::Separator();
  const std::string reason = why_not(studio, command);
  const bool on = command.checked && command.checked(studio);
  const std::string title(command.title);
  if (ImGui::MenuItem(title.c_str(), key_of(studio, command).c_str(), on, reason.empty()))
    run_command(studio, command.name);
  mark_target(studio, "menu:" + std::string(command.name));
  if (!reason.empty()) tooltip(("Not now: " + reason).c_str());
}

void section_title(const Studio& studio, const char* title) {
  ImGui::Dummy({0, 2 * studio.fonts.scale});
  ImGui::PushFont(studio.fonts.bold);
  ImGui::TextUnformatted(title);
  ImGui::PopFont();
}

void empty_hint(const Studio& studio, const char* title, const char* text) {
  const ImVec2 space = ImGui::GetContentRegionAvail();
  const float width = std::min(space.x, 300 * studio.fonts.scale);
  const float height = ImGui::GetTextLineHeight() + ImGui::CalcTextSize(text, nullptr, false, width).y;
  const ImVec2 at = ImGui::GetCursorPos();
  ImGui::SetCursorPos({at.x + (space.x - width) / 2, at.y + std::max(0.0f, (space.y - height) / 2.6f)});
  ImGui::BeginGroup();
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width);
  ImGui::PushFont(studio.fonts.bold);
  ImGui::TextUnformatted(title);
  ImGui::PopFont();
  ImGui::PushStyleColor(ImGuiCol_Text, colours(studio).muted);
  ImGui::TextWrapped("%s", text);
  ImGui::PopStyleColor();
  ImGui::PopTextWrapPos();
  ImGui::EndGroup();
}

void muted_text(const Studio& studio, std::string_view text) {
  ImGui::PushStyleColor(ImGuiCol_Text, colours(studio).muted);
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopStyleColor();
}

void muted_paragraph(const Studio& studio, const char* text) {
  ImGui::PushStyleColor(ImGuiCol_Text, colours(studio).muted);
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(text);
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
}

void tooltip(const char* text) {
  if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) ImGui::SetTooltip("%s", text);
}

std::string fitted(const std::string& text, float width) {
  if (ImGui::CalcTextSize(text.c_str()).x <= width) return text;
  std::string cut = text;
  while (!cut.empty()) {
    cut.pop_back();
    while (!cut.empty() && (static_cast<unsigned char>(cut.back()) & 0xc0) == 0x80)
      cut.pop_back();  // whole letters
    std::string shown = cut + "…";
    if (ImGui::CalcTextSize(shown.c_str()).x <= width) return shown;
  }
  return "";
}

std::string duration_text(double seconds) {
  const auto whole = static_cast<long>(std::lround(std::max(0.0, seconds)));
  if (whole < 60) return std::to_string(whole) + " s";
  if (whole < 3600) return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
  return std::to_string(whole / 3600) + " h " + std::to_string(whole % 3600 / 60) + " min";
}

std::string plural(std::size_t count, const std::string& thing) {
  return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

std::string count_text(std::size_t count) {
  std::string text = std::to_string(count);
  for (auto at = static_cast<std::ptrdiff_t>(text.size()) - 3; at > 0; at -= 3)
    text.insert(static_cast<std::size_t>(at), 1, ',');
  return text;
}

float separator_width(const Studio& studio) {
  return 17 * studio.fonts.scale;
}

void separator_in_line(const Studio& studio) {
  const float before = std::floor(separator_width(studio) / 2);
  ImGui::SameLine(0, before);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetFrameHeight();
  ImGui::GetWindowDrawList()->AddLine({at.x, at.y + height * 0.2f}, {at.x, at.y + height * 0.8f},
                                      ImGui::GetColorU32(colours(studio).border), studio.fonts.scale);
  ImGui::SameLine(0, separator_width(studio) - before);
}

float share_of_width(int columns) {
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  return std::floor((ImGui::GetContentRegionAvail().x - gap * static_cast<float>(columns - 1)) /
                    static_cast<float>(columns));
}

}  // namespace archetype
