#include "app/studio/kept_settings.h"

#include <chrono>
#include <utility>

namespace archetype {

KeptSettings::KeptSettings(std::filesystem::path path, Settings known)
    : path_(std::move(path)),
      asked_(std::move(known)),
      writer_(
          [path = path_](const Settings& settings, const JobControl&) {
            save_settings(path, settings);
            return std::optional(true);
          },
          {}) {}

void KeptSettings::follow(const Settings& settings) {
  writer_.poll();
  if (settings == asked_) return;
  asked_ = settings;
  writer_.request(settings, false);
}

void KeptSettings::finish(const Settings& settings) {
  writer_.poll();
  writer_.wait(std::chrono::seconds(10));  // two would write the same file
  save_settings(path_, settings);
}

}  // namespace archetype
