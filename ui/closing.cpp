#include "ui/closing.h"

#include <imgui.h>

#include <algorithm>

#include "core/session/actions.h"
#include "ui/panels.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

bool is_saved(const Studio& studio) {
  return !unsaved(studio) && studio.autosave.waiting.empty() && !studio.autosave.under_way;
}

bool is_saved_elsewhere_now(const Studio& studio) {
  const std::vector<JobView> jobs = studio.jobs.view();
  return std::ranges::any_of(
      jobs, [](const JobView& job) { return job.active() && job.title.starts_with("Save as"); });
}

std::string title_of(const Studio& studio, CloseQuestion question) {
  if (question == CloseQuestion::untitled) return "Save “" + studio.collection.title + "” as a project?";
  return question == CloseQuestion::homeless ? "Save the templates?" : "What you edited is not saved";
}

// What the program unpacked or made itself has a name in the menu File; where it lies is nobody's concern.
std::string opened_again_as(const Studio& studio) {
  const std::string folder = studio.collection.folder.string();
  const bool own = folder.starts_with(studio.options.folders.cache.string() + "/");
  return own ? "“" + studio.collection.title + "” again" : "this folder: " + folder;
}

std::string text_of(const Studio& studio, CloseQuestion question) {
  switch (question) {
    case CloseQuestion::untitled:
      return "It has no project file of its own yet. What you edited is kept all the same, and is there "
             "again "
             "when you open " +
             opened_again_as(studio) + ".";
    case CloseQuestion::homeless:
      return "They belong to no project yet: without saving them they are gone.";
    case CloseQuestion::unsavable:
      return studio.autosave.problem + "\n\nAs soon as it can be saved, the window closes by itself.";
    case CloseQuestion::none:
      break;
  }
  return "";
}

void discard(Studio& studio, CloseQuestion question) {
  if (question == CloseQuestion::untitled)
    studio.history.commit(studio.autosave.opened, "Discard what was edited");
  if (question == CloseQuestion::unsavable) studio.autosave.given_up = true;
  studio.ui.closing.answered = true;
}

bool answer(Studio& studio, const char* name, const char* label, float width) {
  const bool pressed = ImGui::Button(label, {width, 0});
  mark_target(studio, std::string("close:") + name);
  return pressed;
}

// The first is what Enter does: it loses nothing.
void draw_answers(Studio& studio, CloseQuestion question) {
  Closing& closing = studio.ui.closing;
  const auto tapped = [](ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetIO().KeyMap[key], false); };
  const bool enter = tapped(ImGuiKey_Enter) || tapped(ImGuiKey_KeyPadEnter);
  const int answers = question == CloseQuestion::homeless ? 3 : 4;
  const float width = share_of_width(answers);
  const bool keep = question == CloseQuestion::untitled;
  const bool first_is_main = keep || question == CloseQuestion::unsavable;
  const Palette& p = colours(studio);
  ImGui::PushStyleColor(ImGuiCol_Button, p.accent);
  ImGui::PushStyleColor(ImGuiCol_Text, p.on_accent);
  if (keep && (answer(studio, "keep", "Keep and close", width) || enter)) closing.answered = true;
  if (question == CloseQuestion::unsavable && (answer(studio, "retry", "Try again", width) || enter))
    studio.autosave.not_before = {};
  if (first_is_main) {
    ImGui::PopStyleColor(2);
    ImGui::SameLine();
  }
  const bool enter_saves = !first_is_main && enter && run_command(studio, "save-as");
  if (command_button(studio, "save-as", "Save as…", {width, 0}) || enter_saves) closing.saving_as = true;
  if (!first_is_main) ImGui::PopStyleColor(2);
  ImGui::SameLine();
  const char* drop = question == CloseQuestion::unsavable ? "Close without" : "Discard edits";
  if (answer(studio, "discard", drop, width)) discard(studio, question);
  ImGui::SameLine();
  if (answer(studio, "cancel", "Cancel", width)) closing = {};
}

}  // namespace

CloseQuestion close_question(const Studio& studio) {
  const Autosave& saving = studio.autosave;
  if (saving.given_up) return CloseQuestion::none;
  if (!saving.problem.empty() && !is_saved(studio)) return CloseQuestion::unsavable;
  if (studio.ui.closing.answered) return CloseQuestion::none;
  const Document& document = studio.history.committed();
  if (!studio.collection.open())
    return document.templates.empty() ? CloseQuestion::none : CloseQuestion::homeless;
  return studio.collection.untitled && !(document == saving.opened) ? CloseQuestion::untitled
                                                                    : CloseQuestion::none;
}

void request_close(Studio& studio) {
  if (!studio.attended) {
    studio.quit = true;
    return;
  }
  studio.history.cancel_preview();
  studio.ui.cancel_drag = true;
  studio.ui.closing = {};
  studio.ui.closing.asked = true;
}

void follow_closing(Studio& studio) {
  Closing& closing = studio.ui.closing;
  if (!closing.asked) return;
  if (closing.saving_as) {
    if (studio.ui.browser.open || is_saved_elsewhere_now(studio)) return;
    closing.saving_as = false;
    // The browser was closed without saving, or it failed: then the message says so.
    if (close_question(studio) != CloseQuestion::none) closing = {};
    return;
  }
  if (close_question(studio) != CloseQuestion::none) return;
  if (is_saved(studio) || studio.autosave.given_up) studio.quit = true;
}

bool asks_to_close(const Studio& studio) {
  const Closing& closing = studio.ui.closing;
  return closing.asked && !closing.saving_as && close_question(studio) != CloseQuestion::none;
}

void draw_closing_window(Studio& studio) {
  constexpr const char* id = "###closing";
  const bool asks = asks_to_close(studio);
  const CloseQuestion question = close_question(studio);
  if (asks && !ImGui::IsPopupOpen(id)) ImGui::OpenPopup(id);
  const ImGuiViewport* screen = ImGui::GetMainViewport();
  const float width = std::min(560 * studio.fonts.scale, screen->WorkSize.x * 0.94f);
  ImGui::SetNextWindowPos(screen->GetWorkCenter(), ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({width, 0});
  const std::string title = title_of(studio, question) + id;
  if (!ImGui::BeginPopupModal(title.c_str(), nullptr, ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize))
    return;
  if (asks) {
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(text_of(studio, question).c_str());
    ImGui::PopTextWrapPos();
    ImGui::Dummy({0, 6 * studio.fonts.scale});
    draw_answers(studio, question);
  }
  if (!asks_to_close(studio)) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

}  // namespace archetype
