// The settings file, written beside the window whenever something in it has changed: a program that is killed
// forgets no key that was changed.
#pragma once

#include <filesystem>

#include "core/session/latest_worker.h"
#include "core/session/settings.h"

namespace archetype {

class KeptSettings {
 public:
  // `known` is what the file holds.
  KeptSettings(std::filesystem::path path, Settings known);

  // Once a frame.
  void follow(const Settings& settings);
  // Why they could not be written, once; "" if they could.
  std::string take_problem() { return writer_.take_problem(); }
  // Returns when they are written. Throws FileError.
  void finish(const Settings& settings);

 private:
  std::filesystem::path path_;
  Settings asked_;
  LatestWorker<Settings, bool> writer_;
};

}  // namespace archetype
