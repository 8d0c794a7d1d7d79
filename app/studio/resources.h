// Where the files that come with the program are.
#pragma once

#include <filesystem>

namespace archetype {

struct Resources {
  std::filesystem::path shaders;
  std::filesystem::path assets;
};

// Beside the installed program (PREFIX/share/archetype), or in the source tree that it was built from. Throws
// FileError if they are in neither.
Resources find_resources();

}  // namespace archetype
