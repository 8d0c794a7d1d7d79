// Shortcuts for tests that read shapes from text in the test.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/io/read_shape.h"
#include "tests/support/scratch_folder.h"

namespace archetype::test {

// Reads `content` as a file of that name.
inline ShapeFile read_as(const std::string& name, std::string_view content) {
  const ScratchFolder folder;
  return read_shape(folder.write(name, content));
}

// The faces as lists of corners: {{0, 1, 2}, ...}.
inline std::vector<std::vector<std::uint32_t>> faces(const PolygonMesh& mesh) {
  std::vector<std::vector<std::uint32_t>> result;
  for (std::size_t f = 0; f < mesh.face_count(); ++f)
    result.emplace_back(mesh.face(f).begin(), mesh.face(f).end());
  return result;
}

using Faces = std::vector<std::vector<std::uint32_t>>;

}  // namespace archetype::test
