// A glTF or GLB file taken apart: its description, and its buffers with every byte accounted for.
#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <tiny_gltf.h>

#include "core/io/readers.h"

namespace archetype {

struct GltfFile {
  std::filesystem::path path;
  std::uint64_t bytes = 0;                // of the file and its buffers
  tinygltf::Model model;                  // without buffers, materials, images, animations, skins and cameras
  std::vector<std::string_view> buffers;  // into `owned` or the file itself; as long as the description says
  std::deque<std::string> owned;
  bool external = false;  // some buffer is a file of its own
};

// Everything that could reach outside (URIs) or take memory by a promise (buffers) is settled before tinygltf
// sees the description: it is used for what it is good at, the many structures of the format. Buffers in
// files of their own must lie in the folder of `file` or below, also after following links.
GltfFile open_gltf(const ShapeBytes& file);

}  // namespace archetype
