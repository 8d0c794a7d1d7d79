#include "render/picture_file.h"

#include "core/io/file.h"
#include "core/io/png.h"

namespace archetype {

void write_png(const std::filesystem::path& path, const Picture& picture) {
  replace_file(path, encode_png(picture));
}

}  // namespace archetype
