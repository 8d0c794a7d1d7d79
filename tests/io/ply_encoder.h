// Writes PLY files for tests, value by value, in any of the three encodings.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <sstream>
#include <string>

namespace archetype::test {

enum class PlyFlavour { ascii, little, big };
inline constexpr std::array all_ply_flavours{PlyFlavour::ascii, PlyFlavour::little, PlyFlavour::big};

inline std::string ply_name(PlyFlavour flavour) {
  constexpr std::array names{"ascii", "binary_little_endian", "binary_big_endian"};
  return names[static_cast<std::size_t>(flavour)];
}

class PlyEncoder {
 public:
  explicit PlyEncoder(PlyFlavour flavour) : flavour_(flavour) {}

  // `lines`: what stands between the format and end_header.
  void header(const std::string& lines) {
    bytes_ = "ply\nformat " + ply_name(flavour_) + " 1.0\n" + lines + "end_header\n";
  }

  template <typename T>
  PlyEncoder& value(T value) {
    if (flavour_ == PlyFlavour::ascii) {
      std::ostringstream text;
      text.imbue(std::locale::classic());
      text << +value << ' ';
      bytes_ += text.str();
    } else {
      auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
      const bool native = (flavour_ == PlyFlavour::little) == (std::endian::native == std::endian::little);
      if (!native) std::reverse(raw.begin(), raw.end());
      bytes_.append(raw.data(), raw.size());
    }
    return *this;
  }
  void end_record() {
    if (flavour_ == PlyFlavour::ascii) bytes_ += '\n';
  }
  const std::string& bytes() const { return bytes_; }

 private:
  PlyFlavour flavour_;
  std::string bytes_;
};

}  // namespace archetype::test
