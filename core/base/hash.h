// A 128-bit hash of a file's content: the identity of a shape, and the seed of its samples.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>

namespace archetype {

struct ContentHash {
  std::array<std::uint64_t, 2> words{};

  friend bool operator==(const ContentHash&, const ContentHash&) = default;
  std::string to_hex() const;  // 32 lower-case digits
};

// XXH3-128. Not a cryptographic hash: it tells files apart, it does not guard against forgery.
ContentHash hash_content(std::span<const std::byte> bytes);

}  // namespace archetype
