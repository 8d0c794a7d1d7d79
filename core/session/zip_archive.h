// Reading members of a zip archive (libzip).
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

struct zip;  // libzip's

namespace archetype {

class ZipArchive {
 public:
  // Throws FileError if it cannot be opened, InputError if it is no zip archive.
  explicit ZipArchive(const std::filesystem::path& path);

  bool contains(const std::string& member) const;
  // The whole member, unpacked. Throws InputError if it is not there, is damaged, or holds more than
  // `max_bytes`: what the archive promises is not believed.
  std::string read(const std::string& member, std::uint64_t max_bytes) const;

 private:
  struct Close {
    void operator()(::zip* archive) const;
  };
  std::filesystem::path path_;
  std::unique_ptr<::zip, Close> archive_;
};

}  // namespace archetype
