#include "ui/autosave.h"

#include <algorithm>
#include <utility>

#include "ui/studio.h"

namespace archetype {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds rest_before_retry{5};

bool waits(const Autosave& saving, const std::filesystem::path& project) {
  return std::ranges::find(saving.waiting, project, &SaveDocument::project) != saving.waiting.end();
}

// A failed save comes back to the list, unless a newer one of the same project is there.
void take_over_result(Studio& studio) {
  Autosave& saving = studio.autosave;
  const std::optional<std::string> problem = saving.saver.poll();
  if (!problem || !saving.under_way) return;
  SaveDocument tried = *std::exchange(saving.under_way, std::nullopt);
  // Said once, however often it is tried again.
  if (!problem->empty() && *problem != saving.problem) say(studio, Severity::error, *problem);
  if (problem->empty() && !saving.problem.empty())
    say(studio, Severity::note, "What you edit is saved again");
  saving.problem = *problem;
  if (problem->empty()) return;
  saving.not_before = Clock::now() + rest_before_retry;
  if (!waits(saving, tried.project)) saving.waiting.push_back(std::move(tried));
}

// One at a time: the saver forgets what waits when something newer comes, which may be of another project.
void hand_out(Autosave& saving) {
  if (saving.under_way || saving.waiting.empty()) return;
  saving.under_way = std::move(saving.waiting.front());
  saving.waiting.erase(saving.waiting.begin());
  saving.saver.request(*saving.under_way, false);
}

}  // namespace

Autosave::Autosave(std::function<void()> wake) : saver(save_document, std::move(wake)) {}

bool unsaved(const Studio& studio) {
  const Autosave& saving = studio.autosave;
  const bool document = saving.saved_revision != studio.history.committed_revision();
  if (!studio.collection.open()) return studio.session && document;
  return document || saving.saved_strip != studio.ui.strip.shapes;
}

void save_soon(Studio& studio) {
  if (!unsaved(studio)) return;
  Autosave& saving = studio.autosave;
  saving.saved_revision = studio.history.committed_revision();
  saving.saved_strip = studio.ui.strip.shapes;
  const bool alone = !studio.collection.open();
  const std::filesystem::path& file = alone ? studio.session->document() : studio.collection.path;
  std::erase_if(saving.waiting, [&](const SaveDocument& each) { return each.project == file; });
  saving.waiting.push_back({file, studio.history.committed(), alone, studio.ui.strip.shapes});
}

void autosave(Studio& studio) {
  Autosave& saving = studio.autosave;
  take_over_result(studio);
  save_soon(studio);
  if (Clock::now() >= saving.not_before) hand_out(saving);
}

void save_now(Studio& studio) {
  Autosave& saving = studio.autosave;
  if (saving.given_up) return;
  save_soon(studio);
  // Each is tried once more at most; what fails goes to the end of the list.
  for (std::size_t tries = saving.waiting.size() + (saving.under_way ? 1 : 0); tries > 0; --tries) {
    hand_out(saving);
    while (!saving.saver.idle()) {
      saving.saver.wait(std::chrono::seconds(1));
      take_over_result(studio);
    }
  }
}

}  // namespace archetype
