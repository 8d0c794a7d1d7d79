#include "ui/file_browser.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include "core/io/read_shape.h"
#include "ui/icons.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

namespace fs = std::filesystem;

void go_to(Studio& studio, const fs::path& folder) {
  FileBrowserState& state = studio.ui.browser;
  state.folder = folder.lexically_normal();
  state.asked_to_replace = false;
  if (!state.wanted.saving) state.typed.clear();
  studio.directory.reset();
  studio.directory_reader.request(state.folder, true);
}

bool is_shown(const BrowseFor& wanted, const DirectoryEntry& entry) {
  if (entry.folder) return true;
  if (wanted.folders_only)
    return has_shape_ending(entry.name);  // to see what is in a folder; they are greyed out
  if (wanted.shapes) return has_shape_ending(entry.name);
  return wanted.ending.empty() || entry.name.ends_with(wanted.ending);
}

// The path of the field: what was typed may be a name in the folder, or a path of its own.
fs::path chosen_path(const FileBrowserState& state) {
  const fs::path typed = state.typed;
  fs::path path = typed.is_absolute() ? typed : state.folder / typed;
  if (state.wanted.saving && path.extension() != state.wanted.ending) path += state.wanted.ending;
  return path.lexically_normal();
}

void finish(Studio& studio) {
  FileBrowserState& state = studio.ui.browser;
  std::error_code none;
  const fs::path path = chosen_path(state);
  const bool needs_file = !state.wanted.folders_only && !state.wanted.shapes;
  if (needs_file && !state.wanted.saving && fs::is_directory(path, none)) {
    go_to(studio, path);
    return;
  }
  if (state.wanted.saving && state.wanted.replaces && !state.asked_to_replace && fs::exists(path, none)) {
    state.asked_to_replace = true;
    return;
  }
  studio.settings.last_folder = (state.wanted.folders_only ? path : path.parent_path()).string();
  const std::string arguments[] = {path.string(), std::to_string(state.figure_width), "transparent"};
  const std::size_t count = !state.wanted.figure ? 1 : state.transparent ? 3 : 2;
  // It stays open if the command could not use the path: the status line says why.
  if (run_command(studio, state.wanted.command, std::span(arguments).first(count))) state.open = false;
}

void draw_places(Studio& studio) {
  const UserFolders& folders = studio.options.folders;
  const std::pair<const char*, fs::path> places[] = {
      {"Home", folders.home}, {"Computer", "/"}, {"Projects", folders.data / "projects"}};
  for (const auto& [name, path] : places) {
    std::error_code none;
    if (fs::is_directory(path, none) && ImGui::Selectable(name)) go_to(studio, path);
  }
  if (studio.settings.recent.empty()) return;
  section_title(studio, "Recent");
  for (const std::string& recent : studio.settings.recent) {
    const fs::path path = recent;
    const fs::path folder = path.has_extension() ? path.parent_path() : path;
    if (ImGui::Selectable((path.filename().string() + "##" + recent).c_str())) go_to(studio, folder);
    tooltip(recent.c_str());
  }
}

// The folders from the root to here, each to be clicked.
void draw_crumbs(Studio& studio) {
  fs::path at;
  std::optional<fs::path> wanted;
  int id = 0;
  for (const fs::path& step : studio.ui.browser.folder) {
    at /= step;
    if (step.empty()) continue;
    if (id > 0) ImGui::SameLine(0, 2);
    ImGui::PushID(id++);
    if (ImGui::SmallButton(step.c_str())) wanted = at;
    ImGui::PopID();
  }
  if (wanted) go_to(studio, *wanted);
}

void draw_entry(Studio& studio, const DirectoryEntry& entry) {
  FileBrowserState& state = studio.ui.browser;
  const bool usable = entry.folder || !state.wanted.folders_only;
  const std::string label = std::string(entry.folder ? icon::folder : icon::file) + "  " + entry.name;
  ImGui::BeginDisabled(!usable);
  if (ImGui::Selectable(label.c_str(), state.typed == entry.name, ImGuiSelectableFlags_AllowDoubleClick)) {
    state.typed = entry.name;
    state.asked_to_replace = false;
    if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
      if (entry.folder)
        go_to(studio, state.folder / entry.name);
      else
        finish(studio);
    }
  }
  ImGui::EndDisabled();
  mark_target(studio, "entry:" + entry.name);
}

void draw_entries(Studio& studio) {
  const std::optional<DirectoryListing> listing = studio.directory;  // a double click asks for another one
  if (!listing || listing->folder != studio.ui.browser.folder) {
    muted_text(studio, "Reading…");
    return;
  }
  if (!listing->problem.empty()) {
    muted_paragraph(studio, listing->problem.c_str());
    return;
  }
  std::vector<const DirectoryEntry*> shown;
  for (const DirectoryEntry& entry : listing->entries)
    if (is_shown(studio.ui.browser.wanted, entry)) shown.push_back(&entry);
  if (shown.empty()) muted_text(studio, "Nothing here that could be opened.");
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(shown.size()));
  while (clipper.Step())
    for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row)
      draw_entry(studio, *shown[static_cast<std::size_t>(row)]);
  if (listing->cut) muted_text(studio, "… and more than can be listed: type the name.");
}

void draw_figure_options(Studio& studio) {
  FileBrowserState& state = studio.ui.browser;
  ImGui::AlignTextToFramePadding();
  muted_text(studio, "Pixels wide");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(90 * studio.fonts.scale);
  ImGui::InputInt("##width", &state.figure_width, 0);
  mark_target(studio, "browser:width");
  ImGui::SameLine();
  ImGui::Checkbox("Transparent", &state.transparent);
  mark_target(studio, "browser:transparent");
}

void draw_buttons(Studio& studio) {
  FileBrowserState& state = studio.ui.browser;
  const bool saving = state.wanted.saving;
  const char* word = state.asked_to_replace ? "Replace" : saving ? "Save" : "Open";
  const float width = 96 * studio.fonts.scale;
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - 2 * (width + ImGui::GetStyle().ItemSpacing.x));
  const char* hint = state.wanted.folders_only ? "this folder, or a path" : "name or path";
  if (saving && ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  const ImGuiInputTextFlags flags = ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll;
  const bool entered = ImGui::InputTextWithHint("##typed", hint, &state.typed, flags);
  if (ImGui::IsItemEdited()) state.asked_to_replace = false;
  mark_target(studio, "browser:typed");
  ImGui::SameLine();
  const bool ready = state.wanted.folders_only || !state.typed.empty();
  ImGui::BeginDisabled(!ready);
  const bool pressed = ImGui::Button(word, {width, 0});
  ImGui::EndDisabled();
  mark_target(studio, "browser:open");
  ImGui::SameLine();
  if (ImGui::Button("Cancel", {width, 0})) state.open = false;
  mark_target(studio, "browser:cancel");
  if (state.wanted.figure) draw_figure_options(studio);
  if (state.wanted.figure && state.asked_to_replace) ImGui::SameLine();
  if (state.asked_to_replace) muted_text(studio, "There is a file of this name already.");
  if (ready && (pressed || entered)) finish(studio);
}

}  // namespace

void browse(Studio& studio, const BrowseFor& wanted) {
  FileBrowserState& state = studio.ui.browser;
  state = {};
  state.wanted = wanted;
  state.open = state.newly_open = true;
  state.typed = wanted.proposed;
  std::error_code none;
  const fs::path last = studio.settings.last_folder;
  go_to(studio, fs::is_directory(last, none) ? last : studio.options.folders.home);
}

void draw_file_browser(Studio& studio) {
  FileBrowserState& state = studio.ui.browser;
  if (!state.open) return;
  const ImGuiViewport* screen = ImGui::GetMainViewport();
  const ImVec2 size(std::min(760 * studio.fonts.scale, screen->WorkSize.x * 0.9f),
                    std::min(520 * studio.fonts.scale, screen->WorkSize.y * 0.85f));
  ImGui::SetNextWindowPos(screen->GetWorkCenter(), ImGuiCond_Appearing, {0.5f, 0.5f});
  ImGui::SetNextWindowSize(size, ImGuiCond_Appearing);
  if (std::exchange(state.newly_open, false)) ImGui::SetNextWindowFocus();
  const std::string title = state.wanted.title + "###browser";
  if (ImGui::Begin(title.c_str(), &state.open, ImGuiWindowFlags_NoCollapse)) {
    const float foot = 2 * ImGui::GetFrameHeightWithSpacing();
    draw_crumbs(studio);
    ImGui::BeginChild("places", {170 * studio.fonts.scale, -foot});
    draw_places(studio);
    ImGui::EndChild();
    ImGui::SameLine();
    ImGui::BeginChild("entries", {0, -foot});
    draw_entries(studio);
    ImGui::EndChild();
    draw_buttons(studio);
  }
  ImGui::End();
}

}  // namespace archetype
