#include "app/studio/resources.h"

#include <array>

#include "core/base/error.h"

namespace archetype {

namespace fs = std::filesystem;

Resources find_resources() {
  std::error_code none;
  const fs::path program = fs::read_symlink("/proc/self/exe", none);
  const std::array folders{program.parent_path().parent_path() / "share" / "archetype",
                           fs::path(ARCHETYPE_SOURCE_DIR)};
  for (const fs::path& folder : folders)
    if (fs::is_directory(folder / "shaders", none)) return {folder / "shaders", folder / "assets"};
  throw FileError(folders[0], "the program's own files are missing; install it again");
}

}  // namespace archetype
