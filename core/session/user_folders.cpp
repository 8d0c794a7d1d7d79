#include "core/session/user_folders.h"

#include <cstdlib>

namespace archetype {
namespace {

std::filesystem::path absolute_or(const char* variable, const std::filesystem::path& fallback) {
  const char* value = std::getenv(variable);
  const std::filesystem::path path = value ? value : "";
  return path.is_absolute() ? path : fallback;
}

}  // namespace

UserFolders user_folders() {
  UserFolders folders;
  folders.home = absolute_or("HOME", std::filesystem::temp_directory_path());
  folders.config = absolute_or("XDG_CONFIG_HOME", folders.home / ".config") / "archetype";
  folders.data = absolute_or("XDG_DATA_HOME", folders.home / ".local" / "share") / "archetype";
  folders.cache = absolute_or("XDG_CACHE_HOME", folders.home / ".cache") / "archetype";
  return folders;
}

}  // namespace archetype
