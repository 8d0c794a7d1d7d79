// What is edited comes into the project file as soon as it is made, also while a box is dragged on, and
// always before another project comes into view or the window closes. Templates that are in no project yet
// come into a file of the session.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ui/collection.h"

namespace archetype {

struct Studio;

struct Autosave {
  explicit Autosave(std::function<void()> wake);

  // The committed revision of the history that is in the file, or on its way there; nothing: what is in view
  // never was.
  std::optional<std::uint64_t> saved_revision = 0;
  std::vector<ShapeId> saved_strip;   // the same of the shapes of the strip
  std::uint64_t edited_revision = 0;  // the newest edit that was noted
  Document opened;                    // as it was when the project came into view
  bool given_up = false;              // the window closes without what could not be saved

  std::vector<SaveDocument> waiting;                   // at most one of a project, the newest
  std::optional<SaveDocument> under_way;               // at the saver
  std::chrono::steady_clock::time_point not_before{};  // when a save that failed is tried again
  std::string problem;                                 // why it failed, as it was said; "": it did not

  DocumentSaver saver;
};

// Something was edited that is not even on its way to its file.
bool unsaved(const Studio& studio);
// Once a frame.
void autosave(Studio& studio);
// Puts what is unsaved on its way: before another project is shown.
void save_soon(Studio& studio);
// Returns when all is in the files, or cannot be brought there: then it has said so. For the end.
void save_now(Studio& studio);

}  // namespace archetype
