// The one place that knows stb_image_write.
#include "core/io/png.h"

#include <stb/stb_image_write.h>

#include "core/base/error.h"

namespace archetype {

std::string encode_png(const Picture& picture) {
  std::string bytes;
  const auto append = [](void* context, void* data, int size) {
    static_cast<std::string*>(context)->append(static_cast<const char*>(data),
                                               static_cast<std::size_t>(size));
  };
  if (stbi_write_png_to_func(append, &bytes, picture.width, picture.height, 4, picture.pixels.data(),
                             4 * picture.width) == 0)
    throw PreconditionError("a picture without pixels cannot be written");
  return bytes;
}

}  // namespace archetype
