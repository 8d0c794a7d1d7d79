#include "render/picture_file.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <string>

#include "core/base/error.h"
#include "core/io/png.h"

namespace archetype {

void write_png(const std::filesystem::path& path, const Picture& picture) {
  const std::string bytes = encode_png(picture);
  std::ofstream file(path, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (!file) throw FileError(path, std::string("cannot write this picture: ") + std::strerror(errno));
}

}  // namespace archetype
