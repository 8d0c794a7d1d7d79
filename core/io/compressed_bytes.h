// Bytes made smaller for the project file.
#pragma once

#include <cstddef>

#include "core/io/project_blobs.h"

namespace archetype {

// Pictures of shapes come to a tenth of their bytes, in about a millisecond per 150 kB.
Blob compress_bytes(BlobView bytes);
// Throws BadBlob unless it gives exactly `size` bytes: a hostile blob takes no more memory than that.
Blob decompress_bytes(BlobView compressed, std::size_t size);

}  // namespace archetype
