// Lists a folder beside the window, since a disk or a network may take its time.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/session/latest_worker.h"

namespace archetype {

struct DirectoryEntry {
  std::string name;
  bool folder = false;
};

struct DirectoryListing {
  std::filesystem::path folder;
  std::vector<DirectoryEntry> entries;  // folders first, by name; hidden ones left out
  bool cut = false;                     // there were more than 20,000
  std::string problem;                  // why it cannot be listed
};

std::optional<DirectoryListing> list_directory(const std::filesystem::path& folder,
                                               const JobControl& control);

using DirectoryReader = LatestWorker<std::filesystem::path, DirectoryListing>;

}  // namespace archetype
