// Takes glTF and GLB files apart, and decides what may be read for them.
#include "core/io/gltf_file.h"

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/io/file.h"
#include "core/io/json_input.h"
#include "core/io/text_cursor.h"

namespace archetype {
namespace {

using Json = nlohmann::json;

// Each takes some hundred bytes of memory, however short it is written.
constexpr std::size_t most_entries = 100000;
constexpr std::size_t longest_problem = 300;  // tinygltf says something about every entry

struct Chunks {
  std::string_view json;
  std::string_view binary;
  bool has_binary = false;
};

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (std::size_t i = 4; i-- > 0;) word = word << 8 | static_cast<unsigned char>(bytes[at + i]);
  return word;
}

// GLB: a header of 12 bytes, then chunks, each with its length and kind before it. JSON first, then the
// binary one.
Chunks split_glb(const ShapeBytes& file) {
  constexpr std::uint32_t json_kind = 0x4E4F534A;
  constexpr std::uint32_t binary_kind = 0x004E4942;
  const auto fail = [&](std::size_t byte, const std::string& problem) {
    throw InputError(file.path, "byte " + std::to_string(byte), problem);
  };
  if (file.bytes.size() < 20) fail(0, "the file is too short for binary glTF; it is cut off");
  if (word_at(file.bytes, 4) != 2) {
    fail(4, "expected version 2 of binary glTF, found " + std::to_string(word_at(file.bytes, 4)));
  }
  const std::size_t length = word_at(file.bytes, 8);
  if (length > file.bytes.size()) {
    fail(8, "the header promises " + std::to_string(length) + " bytes, the file has " +
                std::to_string(file.bytes.size()) + "; it is cut off");
  }
  Chunks chunks;
  std::size_t at = 12;
  for (int index = 0; at + 8 <= length; ++index) {
    const std::size_t size = word_at(file.bytes, at);
    const std::uint32_t kind = word_at(file.bytes, at + 4);
    if (size > length - at - 8) fail(at, "a chunk goes beyond the end of the file; it is cut off");
    const std::string_view content = file.bytes.substr(at + 8, size);
    if (index == 0 && kind != json_kind) fail(at + 4, "expected the first chunk to be JSON");
    if (index == 0) chunks.json = content;
    if (index == 1 && kind == binary_kind) {
      chunks.binary = content;
      chunks.has_binary = true;
    }
    at += 8 + size;
  }
  return chunks;
}

std::string percent_decode(std::string_view uri, const ShapeBytes& file) {
  const auto digit = [&](char c) -> int {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    throw InputError(file.path, "", "the URI " + quote(uri) + " has a % without two hexadecimal digits");
  };
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    if (uri[i] == '%') {
      if (i + 2 >= uri.size()) digit('%');
      text += static_cast<char>(digit(uri[i + 1]) * 16 + digit(uri[i + 2]));
      i += 2;
    } else {
      text += uri[i];
    }
  }
  return text;
}

// The file that a URI means, with all links followed; refuses what is not in the folder of `file` or below.
std::filesystem::path resolve(std::string_view uri, const ShapeBytes& file) {
  namespace fs = std::filesystem;
  const auto refuse = [&](const std::string& why) {
    throw InputError(file.path, "", "the URI " + quote(uri) + " " + why);
  };
  const std::string text = percent_decode(uri, file);
  const fs::path relative(text);
  if (text.empty()) refuse("is empty");
  if (text.find_first_of(std::string_view("\\:\0", 3)) != text.npos || relative.is_absolute()) {
    refuse("is no relative path; only files beside this one are opened");
  }
  if (std::ranges::find(relative, "..") != relative.end())
    refuse("leaves the file's folder, which is not allowed");
  std::error_code error;
  const fs::path folder = fs::canonical(file.path.has_parent_path() ? file.path.parent_path() : ".", error);
  if (error) refuse("cannot be found (" + error.message() + ")");
  fs::path target = fs::canonical(folder / relative, error);
  if (error) refuse("cannot be found (" + error.message() + ")");
  const auto [end, unused] = std::ranges::mismatch(folder, target);
  if (end != folder.end()) refuse("is a link that leaves the file's folder, which is not allowed");
  return target;
}

void load_buffers(const Json& document, const Chunks& chunks, const ShapeBytes& file, GltfFile& gltf) {
  const auto buffers = document.find("buffers");
  if (buffers == document.end()) return;
  std::map<std::filesystem::path, std::string_view> read;  // several buffers may be one file
  std::uint64_t bytes_left = max_file_bytes;               // for all of them
  for (std::size_t i = 0; i < buffers->size(); ++i) {
    const Json& buffer = (*buffers)[i];
    const std::string place = "buffers[" + std::to_string(i) + "]";
    const auto length = buffer.find("byteLength");
    if (!buffer.is_object() || length == buffer.end() || !length->is_number_unsigned()) {
      throw InputError(file.path, place, "expected an object with a byteLength of 0 or more");
    }
    std::string_view bytes;
    const auto uri = buffer.find("uri");
    if (uri == buffer.end()) {
      if (i > 0 || !chunks.has_binary)
        throw InputError(file.path, place, "has neither a uri nor a binary chunk");
      bytes = chunks.binary;
    } else if (!uri->is_string()) {
      throw InputError(file.path, place, "expected the uri to be a text");
    } else if (const auto& text = uri->get_ref<const std::string&>(); text.starts_with("data:")) {
      std::vector<unsigned char> decoded;
      std::string mime_type;
      if (!tinygltf::DecodeDataURI(&decoded, mime_type, text, 0, false)) {
        throw InputError(file.path, place,
                         "the data: URI " + quote(text) + " cannot be decoded; expected base64");
      }
      bytes = gltf.owned.emplace_back(decoded.begin(), decoded.end());
    } else {
      const std::filesystem::path target = resolve(text, file);
      const auto [entry, is_new] = read.try_emplace(target);
      if (is_new) {
        std::error_code unknown;  // then reading it says why
        const std::uintmax_t size = std::filesystem::file_size(target, unknown);
        if (!unknown && size > bytes_left)
          throw InputError(
              file.path, place,
              "the buffers hold more than " + std::to_string(max_file_bytes) + " bytes together");
        entry->second = gltf.owned.emplace_back(read_file(target, bytes_left));
        bytes_left -= entry->second.size();
      }
      bytes = entry->second;
      gltf.external = true;
    }
    const auto promised = length->get<std::uint64_t>();
    if (promised > bytes.size()) {
      throw InputError(file.path, place,
                       "promises " + std::to_string(promised) + " bytes, but there are only " +
                           std::to_string(bytes.size()) + "; a file is cut off");
    }
    gltf.buffers.push_back(bytes.substr(0, promised));
  }
}

void refuse_compression(const Json& document, const ShapeBytes& file) {
  const auto required = document.find("extensionsRequired");
  if (required == document.end() || !required->is_array()) return;
  for (const char* name : {"KHR_draco_mesh_compression", "EXT_meshopt_compression"}) {
    if (std::ranges::find(*required, Json(name)) != required->end()) {
      throw InputError(
          file.path, "extensionsRequired",
          std::string("the geometry is compressed (") + name + "), which is not supported; save it without");
    }
  }
}

void limit_entries(const Json& document, const ShapeBytes& file) {
  for (const auto& [key, value] : document.items()) {
    if (!value.is_array() || value.size() <= most_entries) continue;
    throw InputError(file.path, key, "more than " + std::to_string(most_entries) + " entries");
  }
}

// What tinygltf gets to see: the geometry and where it stands. No buffers, so that it opens no file and
// copies no bytes, and nothing that it would decode for us to throw away.
Json geometry_only(const Json& document) {
  constexpr std::array<std::string_view, 7> keys{"asset",  "scene",     "scenes",     "nodes",
                                                 "meshes", "accessors", "bufferViews"};
  Json kept = Json::object();
  for (const std::string_view key : keys) {
    const auto found = document.find(key);
    if (found != document.end()) kept[std::string(key)] = *found;
  }
  return kept;
}

}  // namespace

GltfFile open_gltf(const ShapeBytes& file) {
  Chunks chunks{file.bytes, {}, false};
  if (file.bytes.starts_with("glTF")) chunks = split_glb(file);
  const Json document = parse_json(chunks.json, file.path);
  if (!document.is_object() || !document.contains("asset")) {
    throw InputError(file.path, "", "expected a glTF document: a JSON object with the key \"asset\"");
  }
  limit_entries(document, file);
  refuse_compression(document, file);
  GltfFile gltf;
  gltf.path = file.path;
  gltf.bytes = file.bytes.size();
  load_buffers(document, chunks, file, gltf);
  for (const std::string& buffer : gltf.owned) gltf.bytes += buffer.size();

  const std::string kept = geometry_only(document).dump();
  std::string problem;
  std::string warning;
  bool loaded = false;
  try {
    loaded = tinygltf::TinyGLTF().LoadASCIIFromString(&gltf.model, &problem, &warning, kept.data(),
                                                      static_cast<unsigned>(kept.size()), "");
  } catch (const std::exception& error) {
    problem = error.what();
  }
  if (!loaded) {
    std::ranges::replace(problem, '\n', ' ');
    throw InputError(file.path, "", "not valid glTF: " + problem.substr(0, longest_problem));
  }
  return gltf;
}

}  // namespace archetype
