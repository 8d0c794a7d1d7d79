// Ctrl+P: every command, found by any of its words.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <sstream>

#include "ui/panels.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

std::string lower(std::string_view text) {
  std::string low(text);
  for (char& c : low) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return low;
}

// Every word typed has to be in the title, the name or the menu.
bool matches(const Command& command, const std::string& query) {
  const std::string all = lower(command.title) + " " + std::string(command.name) + " " + lower(command.menu);
  std::istringstream words(lower(query));
  for (std::string word; words >> word;)
    if (all.find(word) == std::string::npos) return false;
  return true;
}

// Only commands that need no arguments: the others ask for them in a window or are for scripts.
std::vector<const Command*> found_commands(const Studio& studio) {
  std::vector<const Command*> found;
  for (const Command& command : studio.commands) {
    const bool needs_arguments = !command.arguments.empty() && command.arguments[0] != '[';
    if (!needs_arguments && command.name != "palette" && matches(command, studio.ui.palette.query))
      found.push_back(&command);
  }
  // What can be done now comes first.
  std::stable_partition(found.begin(), found.end(),
                        [&](const Command* c) { return why_not(studio, *c).empty(); });
  return found;
}

void draw_command(Studio& studio, const Command& command, bool chosen, bool& run) {
  const std::string reason = why_not(studio, command);
  const std::string title(command.title);
  const float right = ImGui::GetContentRegionAvail().x;
  if (!reason.empty()) ImGui::PushStyleColor(ImGuiCol_Text, colours(studio).muted);
  if (ImGui::Selectable((title + "##" + std::string(command.name)).c_str(), chosen)) run = true;
  if (!reason.empty()) ImGui::PopStyleColor();
  mark_target(studio, "palette:" + std::string(command.name));
  if (chosen && ImGui::IsWindowAppearing()) ImGui::SetScrollHereY();
  const std::string note = reason.empty() ? key_of(studio, command) : reason;
  ImGui::SameLine(std::max(ImGui::CalcTextSize(title.c_str()).x + 24 * studio.fonts.scale,
                           right - ImGui::CalcTextSize(note.c_str()).x));
  muted_text(studio, note);
}

}  // namespace

void draw_command_palette(Studio& studio) {
  PaletteState& state = studio.ui.palette;
  if (!state.open) return;
  const ImGuiViewport* screen = ImGui::GetMainViewport();
  const float width = std::min(620 * studio.fonts.scale, screen->WorkSize.x * 0.9f);
  ImGui::SetNextWindowPos(
      {screen->GetWorkCenter().x - width / 2, screen->WorkPos.y + 40 * studio.fonts.scale});
  ImGui::SetNextWindowSize({width, 0});
  const bool newly_open = std::exchange(state.newly_open, false);
  if (newly_open) ImGui::SetNextWindowFocus();
  constexpr ImGuiWindowFlags flags =
      ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings;
  ImGui::Begin("##palette", nullptr, flags);
  if (newly_open) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-1);
  const bool entered = ImGui::InputTextWithHint("##query", "What do you want to do?", &state.query,
                                                ImGuiInputTextFlags_EnterReturnsTrue);
  mark_target(studio, "palette:query");
  if (ImGui::IsItemEdited()) state.chosen = 0;

  const std::vector<const Command*> found = found_commands(studio);
  const ImGuiIO& io = ImGui::GetIO();
  const auto tapped = [&](ImGuiKey key) { return ImGui::IsKeyPressed(io.KeyMap[key]); };
  if (tapped(ImGuiKey_DownArrow)) ++state.chosen;
  if (tapped(ImGuiKey_UpArrow) && state.chosen > 0) --state.chosen;
  state.chosen = found.empty() ? 0 : std::min(state.chosen, found.size() - 1);

  const Command* wanted = entered && !found.empty() ? found[state.chosen] : nullptr;
  ImGui::BeginChild("##found", {0, 11 * ImGui::GetTextLineHeightWithSpacing()});
  for (std::size_t i = 0; i < found.size(); ++i) {
    bool run = false;
    draw_command(studio, *found[i], i == state.chosen, run);
    if (i == state.chosen && (tapped(ImGuiKey_DownArrow) || tapped(ImGuiKey_UpArrow)))
      ImGui::SetScrollHereY();
    if (run) wanted = found[i];
  }
  if (found.empty()) muted_text(studio, "No command has all of these words.");
  ImGui::EndChild();
  if (!newly_open && !ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows)) state.open = false;
  ImGui::End();
  if (!wanted) return;
  state.open = false;
  run_command(studio, wanted->name);
}

}  // namespace archetype
