// A temporary folder for the files of one test.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace archetype::test {

// Made on construction, removed with all it holds on destruction.
class ScratchFolder {
 public:
  ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder();

  const std::filesystem::path& path() const { return path_; }
  // Writes a file into the folder (subfolders are made) and returns its path.
  std::filesystem::path write(const std::string& name, std::string_view content) const;

 private:
  std::filesystem::path path_;
};

}  // namespace archetype::test
