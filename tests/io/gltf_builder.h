// Builds glTF files for tests: a buffer that grows, and the views and accessors into it.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <vector>

namespace archetype::test {

inline void append_word(std::string& bytes, std::uint32_t word) {
  for (int i = 0; i < 4; ++i) bytes += static_cast<char>(word >> (8 * i) & 0xFF);
}

inline std::string base64(const std::string& bytes) {
  const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      word = word << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k <= bytes.size() ? digits[word >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

inline std::string glb(std::string json, std::string binary) {
  json.resize((json.size() + 3) / 4 * 4, ' ');
  binary.resize((binary.size() + 3) / 4 * 4, '\0');
  std::string bytes = "glTF";
  append_word(bytes, 2);
  append_word(bytes,
              static_cast<std::uint32_t>(12 + 8 + json.size() + (binary.empty() ? 0 : 8 + binary.size())));
  append_word(bytes, static_cast<std::uint32_t>(json.size()));
  append_word(bytes, 0x4E4F534A);
  bytes += json;
  if (binary.empty()) return bytes;
  append_word(bytes, static_cast<std::uint32_t>(binary.size()));
  append_word(bytes, 0x004E4942);
  return bytes + binary;
}

class GltfBuilder {
 public:
  // Appends numbers to the buffer as T, aligned to four bytes, as a buffer view of their own. Returns its
  // index.
  template <typename T>
  int view(const std::vector<double>& numbers, int stride = 0) {
    data_.resize((data_.size() + 3) / 4 * 4, '\0');
    const std::size_t begin = data_.size();
    for (const double number : numbers) {
      const auto raw = std::bit_cast<std::array<char, sizeof(T)>>(static_cast<T>(number));
      data_.append(raw.data(), raw.size());
    }
    return view_of(begin, data_.size() - begin, stride);
  }
  int view_of(std::size_t begin, std::size_t length, int stride = 0) {
    views_ += std::string(views_.empty() ? "" : ",") +
              "{\"buffer\":0,\"byteOffset\":" + std::to_string(begin) +
              ",\"byteLength\":" + std::to_string(length) +
              (stride > 0 ? ",\"byteStride\":" + std::to_string(stride) : "") + "}";
    return view_count_++;
  }
  // `more`: further keys, such as "\"normalized\":true".
  int accessor(int view, int component_type, const std::string& type, std::size_t count,
               const std::string& more = "") {
    accessors_ += std::string(accessors_.empty() ? "" : ",") + "{" +
                  (view >= 0 ? "\"bufferView\":" + std::to_string(view) + "," : "") +
                  "\"componentType\":" + std::to_string(component_type) +
                  ",\"count\":" + std::to_string(count) + ",\"type\":\"" + type + "\"" +
                  (more.empty() ? "" : "," + more) + "}";
    return accessor_count_++;
  }
  int positions(const std::vector<double>& xyz) {
    return accessor(view<float>(xyz), 5126, "VEC3", xyz.size() / 3);
  }
  int indices(const std::vector<double>& numbers) {
    return accessor(view<std::uint16_t>(numbers), 5123, "SCALAR", numbers.size());
  }

  const std::string& data() const { return data_; }
  // `uri`: of the buffer; empty for the binary chunk. `rest`: meshes, nodes, scenes and so on.
  std::string json(const std::string& uri, const std::string& rest) const {
    return "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{" +
           (uri.empty() ? "" : "\"uri\":\"" + uri + "\",") +
           "\"byteLength\":" + std::to_string(data_.size()) + "}],\"bufferViews\":[" + views_ +
           "],\"accessors\":[" + accessors_ + "]," + rest + "}";
  }
  std::string embedded(const std::string& rest) const {
    return json("data:application/octet-stream;base64," + base64(data_), rest);
  }
  std::string binary(const std::string& rest) const { return glb(json("", rest), data_); }

 private:
  std::string data_;
  std::string views_;
  std::string accessors_;
  int view_count_ = 0;
  int accessor_count_ = 0;
};

}  // namespace archetype::test
