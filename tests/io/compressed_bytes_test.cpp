// Bytes that are made smaller come back as they were, and damaged ones are refused.
#include "core/io/compressed_bytes.h"

#include <doctest/doctest.h>

using namespace archetype;

TEST_CASE("Bytes come back as they were; those of pictures are far fewer") {
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, std::size_t{100'000}}) {
    Blob bytes(size);
    for (std::size_t i = 0; i < size; ++i) bytes[i] = std::byte(i / 500 % 7);
    const Blob compressed = compress_bytes(bytes);
    CHECK(decompress_bytes(compressed, size) == bytes);
    if (size > 1000) CHECK(compressed.size() < size / 20);
  }
}

TEST_CASE("Damaged, cut and wrongly sized bytes are refused") {
  const Blob bytes(5000, std::byte{3});
  Blob compressed = compress_bytes(bytes);
  CHECK_THROWS_AS(decompress_bytes(compressed, 4999), BadBlob);
  CHECK_THROWS_AS(decompress_bytes(compressed, 5001), BadBlob);
  CHECK_THROWS_AS(decompress_bytes(BlobView(compressed).first(compressed.size() / 2), 5000), BadBlob);
  CHECK_THROWS_AS(decompress_bytes({}, 5000), BadBlob);
  compressed[0] = std::byte{0};
  CHECK_THROWS_AS(decompress_bytes(compressed, 5000), BadBlob);
}
