#include "ui/recovery.h"

#include <imgui.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/session/actions.h"
#include "ui/panels.h"
#include "ui/project_actions.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

std::string name_of(const LostSession& lost) {
  return lost.document ? plural(lost.document->templates.size(), "template") + " of no project"
                       : lost.record.title;
}

void forget(Studio& studio, std::size_t index) {
  forget_session(studio.lost[index]);
  studio.lost.erase(studio.lost.begin() + static_cast<std::ptrdiff_t>(index));
}

void bring_back(Studio& studio, std::size_t index) {
  const LostSession lost = studio.lost[index];
  if (lost.document) {
    for (const auto& part_template : lost.document->templates)
      add_template(studio.history, *part_template, "Bring back " + part_template->name);
    forget(studio, index);
    return;
  }
  try {
    reopen_project(studio, lost.record);
    forget(studio, index);
  } catch (const std::exception& error) {
    say(studio, Severity::error, error.what());
  }
}

void draw_lost(Studio& studio, std::size_t index, float width) {
  const LostSession& lost = studio.lost[index];
  const std::string number = std::to_string(index);
  ImGui::PushID(static_cast<int>(index));
  ImGui::AlignTextToFramePadding();
  const float room = ImGui::GetContentRegionAvail().x - (lost.document ? 2 : 1) * (width + 8) - 8;
  ImGui::TextUnformatted(fitted(name_of(lost), room * 0.6f).c_str());
  if (!lost.record.project.empty()) tooltip(lost.record.project.c_str());
  ImGui::SameLine(room * 0.64f);
  muted_text(studio, fitted(lost.when, room * 0.36f));
  ImGui::SameLine(room + 8);
  const bool has_document = lost.document.has_value();
  const bool wanted = ImGui::Button(has_document ? "Bring back" : "Open it", {width, 0});
  mark_target(studio, "recovery:open:" + number);
  bool dropped = false;
  if (has_document) {
    ImGui::SameLine();
    dropped = ImGui::Button("Discard", {width, 0});
    mark_target(studio, "recovery:discard:" + number);
  }
  ImGui::PopID();
  if (wanted)
    bring_back(studio, index);
  else if (dropped)
    forget(studio, index);
}

}  // namespace

void begin_session(Studio& studio) {
  const std::filesystem::path folder = studio.options.folders.data / "sessions";
  studio.lost = lost_sessions(folder);
  try {
    studio.session.emplace(folder);
  } catch (const Error& error) {
    studio.messages.warn(std::string("After a crash, nothing could be offered: ") + error.what());
  }
}

void note_open_project(Studio& studio) {
  const Collection& open = studio.collection;
  for (std::size_t i = studio.lost.size(); i-- > 0;) {
    if (studio.lost[i].document || studio.lost[i].record.project != open.path) continue;
    forget(studio, i);
    say(studio, Severity::note,
        open.title + " was open when the program ended unexpectedly: every edit that was made is there");
  }
  if (!studio.session) return;
  try {
    studio.session->record({open.path, open.title, open.folder});
  } catch (const Error& error) {
    studio.messages.warn(std::string("After a crash, this project could not be offered: ") + error.what());
  }
}

bool offers_recovery(const Studio& studio) {
  return !studio.lost.empty() && !asks_to_close(studio);
}

void close_recovery(Studio& studio) {
  for (const LostSession& lost : studio.lost)
    if (!lost.document) forget_session(lost);
  studio.lost.clear();
  if (!studio.collection.open() && studio.jobs.idle()) open_seats(studio);
}

void draw_recovery_window(Studio& studio) {
  constexpr const char* id = "The program ended unexpectedly###recovery";
  if (offers_recovery(studio) && !ImGui::IsPopupOpen(id)) ImGui::OpenPopup(id);
  const ImGuiViewport* screen = ImGui::GetMainViewport();
  const float width = std::min(600 * studio.fonts.scale, screen->WorkSize.x * 0.94f);
  ImGui::SetNextWindowPos(screen->GetWorkCenter(), ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({width, 0});
  if (!ImGui::BeginPopupModal(id, nullptr, ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize)) return;
  muted_paragraph(studio, "This was open. Every edit was saved when it was made, and is there.");
  ImGui::Dummy({0, 4 * studio.fonts.scale});
  const float button = 110 * studio.fonts.scale;
  const std::size_t count = studio.lost.size();
  for (std::size_t i = 0; i < count && studio.lost.size() == count; ++i) draw_lost(studio, i, button);
  ImGui::Dummy({0, 4 * studio.fonts.scale});
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x - button);
  if (ImGui::Button("Not now", {button, 0})) close_recovery(studio);
  mark_target(studio, "recovery:close");
  if (!offers_recovery(studio)) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

}  // namespace archetype
