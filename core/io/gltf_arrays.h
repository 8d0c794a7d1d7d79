// The arrays of a glTF file: dense, interleaved or sparse, of any number type, checked against the buffers'
// bytes.
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/vector.h"
#include "core/io/gltf_file.h"

namespace archetype {

class GltfArrays {
 public:
  // `gltf` is referred to.
  explicit GltfArrays(const GltfFile& gltf);

  // All elements of an accessor. Throws InputError for an index, offset, count or type that does not fit, and
  // once more has been read than the file's size allows: the same bytes may be used by many meshes and nodes.
  std::vector<Vec3> positions(int accessor);
  std::vector<std::uint32_t> indices(int accessor);

  // Takes from what may still be read and made.
  void spend(std::uint64_t elements);

 private:
  struct Elements;
  [[noreturn]] void fail(int accessor, const std::string& problem) const;
  // `count` elements of a buffer view from byte `offset` of it on.
  Elements find(int accessor, int view, std::size_t offset, std::size_t count, int component_type,
                std::size_t components) const;
  // The numbers of all elements one after the other.
  std::vector<double> numbers(int accessor, int type);
  void apply_sparse(int accessor, std::size_t components, std::vector<double>& numbers) const;

  const GltfFile& gltf_;
  std::uint64_t bytes_;   // of the file and its buffers
  std::uint64_t budget_;  // elements
};

}  // namespace archetype
