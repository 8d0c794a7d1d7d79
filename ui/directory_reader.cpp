#include "ui/directory_reader.h"

#include <algorithm>
#include <system_error>
#include <tuple>

namespace archetype {

std::optional<DirectoryListing> list_directory(const std::filesystem::path& folder,
                                               const JobControl& control) {
  constexpr std::size_t most = 20'000;
  DirectoryListing listing;
  listing.folder = folder;
  std::error_code error;
  std::filesystem::directory_iterator entry(folder, error);
  for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
    if (control.cancelled()) return std::nullopt;
    const std::string name = entry->path().filename().string();
    if (name.empty() || name[0] == '.') continue;
    if (listing.entries.size() == most) {
      listing.cut = true;
      break;
    }
    std::error_code none;
    listing.entries.push_back({name, entry->is_directory(none)});
  }
  if (error) listing.problem = folder.string() + ": " + error.message();
  std::sort(listing.entries.begin(), listing.entries.end(),
            [](const DirectoryEntry& a, const DirectoryEntry& b) {
              return std::tuple(!a.folder, a.name) < std::tuple(!b.folder, b.name);
            });
  return listing;
}

}  // namespace archetype
