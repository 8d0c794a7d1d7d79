// The table of fits of the open project, read beside the window, and only while something that is drawn
// needs it.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "core/session/fit_table.h"
#include "core/session/latest_worker.h"

namespace archetype {

struct Studio;

struct FitTableRequest {
  std::filesystem::path project;
  std::uint64_t revision = 0;                     // of the collection
  std::shared_ptr<const FitTable> previous = {};  // of the same project; only what has changed is read
};
struct ReadFitTable {
  std::shared_ptr<const FitTable> table;  // null: the project could not be read just now
  FitTableRequest of;
};
using FitTableReader = LatestWorker<FitTableRequest, ReadFitTable>;

struct FitTables {
  explicit FitTables(std::function<void()> wake);

  ReadFitTable newest;
  FitTableRequest asked;
  bool wanted = false;  // in this frame
  std::chrono::steady_clock::time_point asked_at{};
  FitTableReader reader;
};

// The newest table there is, which may be a little behind a running job; null while there is none. Asks for
// a newer one at the end of the frame. Each table has an address of its own: compare it to follow changes.
std::shared_ptr<const FitTable> use_fit_table(Studio& studio);

// Once a frame, before and after its panels.
void begin_fit_tables(Studio& studio);
void end_fit_tables(Studio& studio);
bool fit_tables_settled(const Studio& studio);

}  // namespace archetype
