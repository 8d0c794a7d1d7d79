#include "core/io/compressed_bytes.h"

#include <zlib.h>

#include <new>

namespace archetype {
namespace {

const Bytef* read_from(BlobView bytes) {
  return reinterpret_cast<const Bytef*>(bytes.data());
}

Bytef* write_to(Blob& bytes) {
  return reinterpret_cast<Bytef*>(bytes.data());
}

}  // namespace

Blob compress_bytes(BlobView bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  Blob compressed(size);
  const int done = compress2(write_to(compressed), &size, read_from(bytes), static_cast<uLong>(bytes.size()),
                             Z_BEST_SPEED);
  if (done != Z_OK) throw std::bad_alloc();  // its only reason, with room for the bound
  compressed.resize(size);
  return compressed;
}

Blob decompress_bytes(BlobView compressed, std::size_t size) {
  Blob bytes(size);
  uLongf filled = static_cast<uLongf>(size);
  const int done =
      uncompress(write_to(bytes), &filled, read_from(compressed), static_cast<uLong>(compressed.size()));
  if (done == Z_MEM_ERROR) throw std::bad_alloc();
  if (done != Z_OK || filled != size) throw BadBlob("compressed bytes are damaged");
  return bytes;
}

}  // namespace archetype
