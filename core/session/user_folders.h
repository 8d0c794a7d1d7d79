// Where a user's own files belong (XDG base directory specification).
#pragma once

#include <filesystem>

namespace archetype {

struct UserFolders {
  std::filesystem::path home;
  std::filesystem::path config;  // settings
  std::filesystem::path data;    // projects that were never saved elsewhere
  std::filesystem::path cache;   // what can be made again
};

// From XDG_CONFIG_HOME, XDG_DATA_HOME, XDG_CACHE_HOME and HOME; relative values are ignored, as the
// specification asks. Makes no folder.
UserFolders user_folders();

}  // namespace archetype
