#include "core/session/zip_archive.h"

#include <zip.h>

#include <array>

#include "core/base/error.h"

namespace archetype {
namespace {

struct CloseMember {
  void operator()(zip_file_t* file) const { zip_fclose(file); }
};

}  // namespace

void ZipArchive::Close::operator()(::zip* archive) const {
  zip_discard(archive);
}

ZipArchive::ZipArchive(const std::filesystem::path& path) : path_(path) {
  int code = 0;
  archive_.reset(zip_open(path.c_str(), ZIP_RDONLY, &code));
  if (archive_) return;
  zip_error_t error;
  zip_error_init_with_code(&error, code);
  const std::string reason = zip_error_strerror(&error);
  zip_error_fini(&error);
  if (code == ZIP_ER_NOZIP || code == ZIP_ER_INCONS)
    throw InputError(path, "", "no zip archive (" + reason + ")");
  throw FileError(path, reason);
}

bool ZipArchive::contains(const std::string& member) const {
  return zip_name_locate(archive_.get(), member.c_str(), 0) >= 0;
}

std::string ZipArchive::read(const std::string& member, std::uint64_t max_bytes) const {
  const std::unique_ptr<zip_file_t, CloseMember> file(zip_fopen(archive_.get(), member.c_str(), 0));
  if (!file) throw InputError(path_, member, zip_strerror(archive_.get()));
  std::string content;
  std::array<char, 1 << 16> block{};
  for (;;) {
    const zip_int64_t count = zip_fread(file.get(), block.data(), block.size());
    if (count < 0) throw InputError(path_, member, "damaged");
    if (count == 0) return content;
    if (content.size() + static_cast<std::uint64_t>(count) > max_bytes)
      throw InputError(path_, member,
                       "holds more than the " + std::to_string(max_bytes) + " bytes expected at most");
    content.append(block.data(), static_cast<std::size_t>(count));
  }
}

}  // namespace archetype
