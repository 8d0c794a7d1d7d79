// The one place that knows stb_image_write.
#include "render/picture_file.h"

#include <stb/stb_image_write.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <string>

#include "core/base/error.h"

namespace archetype {

void write_png(const std::filesystem::path& path, const Picture& picture) {
  std::string bytes;
  const auto append = [](void* context, void* data, int size) {
    static_cast<std::string*>(context)->append(static_cast<const char*>(data),
                                               static_cast<std::size_t>(size));
  };
  if (stbi_write_png_to_func(append, &bytes, picture.width, picture.height, 4, picture.pixels.data(),
                             4 * picture.width) == 0)
    throw PreconditionError("a picture without pixels cannot be written");
  std::ofstream file(path, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (!file) throw FileError(path, std::string("cannot write this picture: ") + std::strerror(errno));
}

}  // namespace archetype
