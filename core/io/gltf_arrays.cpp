// Reads the arrays of a glTF file. Offsets and lengths come from the file, so that all are checked without
// overflow before a byte is touched.
#include "core/io/gltf_arrays.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/base/error.h"

namespace archetype {
namespace {

// However small a file is, instances may make this many vertices and corners of it: some 100 MB.
constexpr std::uint64_t least_budget = 4 << 20;

template <typename T>
double load(const char* bytes) {
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), bytes, sizeof(T));
  if constexpr (std::endian::native == std::endian::big) std::reverse(raw.begin(), raw.end());
  return static_cast<double>(std::bit_cast<T>(raw));
}

double load_component(const char* bytes, int type) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return load<std::int8_t>(bytes);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return load<std::uint8_t>(bytes);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return load<std::int16_t>(bytes);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return load<std::uint16_t>(bytes);
    case TINYGLTF_COMPONENT_TYPE_INT:
      return load<std::int32_t>(bytes);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return load<std::uint32_t>(bytes);
    case TINYGLTF_COMPONENT_TYPE_DOUBLE:
      return load<double>(bytes);
    default:
      return load<float>(bytes);
  }
}

// What a normalised integer of this type is divided by; 1 for types that cannot be normalised.
double normal_divisor(int type) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return std::numeric_limits<std::int8_t>::max();
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return std::numeric_limits<std::uint8_t>::max();
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return std::numeric_limits<std::int16_t>::max();
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return std::numeric_limits<std::uint16_t>::max();
    default:
      return 1;
  }
}

}  // namespace

struct GltfArrays::Elements {
  const char* begin = nullptr;
  std::size_t stride = 0;
  std::size_t component_bytes = 0;
  int component_type = 0;

  double at(std::size_t element, std::size_t component) const {
    return load_component(begin + element * stride + component * component_bytes, component_type);
  }
};

GltfArrays::GltfArrays(const GltfFile& gltf) : gltf_(gltf), bytes_(gltf.bytes) {
  budget_ = std::max(least_budget, 4 * bytes_);
}

void GltfArrays::spend(std::uint64_t elements) {
  if (elements > budget_) {
    throw InputError(gltf_.path, "",
                     "has more vertices and corners than its size allows; instances count each time");
  }
  budget_ -= elements;
}

void GltfArrays::fail(int accessor, const std::string& problem) const {
  throw InputError(gltf_.path, "accessors[" + std::to_string(accessor) + "]", problem);
}

GltfArrays::Elements GltfArrays::find(int accessor, int view_index, std::size_t offset, std::size_t count,
                                      int component_type, std::size_t components) const {
  const int component_bytes = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(component_type));
  if (component_bytes <= 0) fail(accessor, "has an unknown component type");
  if (view_index < 0 || static_cast<std::size_t>(view_index) >= gltf_.model.bufferViews.size()) {
    fail(accessor, "refers to bufferViews[" + std::to_string(view_index) + "], which is not there");
  }
  const tinygltf::BufferView& view = gltf_.model.bufferViews[static_cast<std::size_t>(view_index)];
  if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= gltf_.buffers.size()) {
    fail(accessor, "refers to buffers[" + std::to_string(view.buffer) + "], which is not there");
  }
  const std::string_view buffer = gltf_.buffers[static_cast<std::size_t>(view.buffer)];
  if (view.byteOffset > buffer.size() || view.byteLength > buffer.size() - view.byteOffset) {
    fail(accessor,
         "its buffer view goes beyond the " + std::to_string(buffer.size()) + " bytes of the buffer");
  }
  const std::size_t element_bytes = components * static_cast<std::size_t>(component_bytes);
  const std::size_t stride = view.byteStride == 0 ? element_bytes : view.byteStride;
  if (stride < element_bytes) fail(accessor, "its elements overlap: the stride is too small");
  // offset + (count - 1) * stride + element_bytes <= byteLength, in an order that cannot overflow.
  if (count > 0 && (offset > view.byteLength || element_bytes > view.byteLength - offset ||
                    (view.byteLength - offset - element_bytes) / stride < count - 1)) {
    fail(accessor, "promises " + std::to_string(count) + " elements, which the " +
                       std::to_string(view.byteLength) + " bytes of its buffer view cannot hold");
  }
  return {buffer.data() + view.byteOffset + std::min(offset, view.byteLength), stride,
          static_cast<std::size_t>(component_bytes), component_type};
}

std::vector<double> GltfArrays::numbers(int index, int type) {
  if (index < 0 || static_cast<std::size_t>(index) >= gltf_.model.accessors.size()) {
    fail(index, "is referred to, but is not there");
  }
  const tinygltf::Accessor& accessor = gltf_.model.accessors[static_cast<std::size_t>(index)];
  if (accessor.type != type)
    fail(index, "has the wrong type; expected VEC3 for positions, SCALAR for indices");
  if (accessor.count > bytes_) fail(index, "promises more elements than the file has bytes");
  spend(accessor.count);
  const auto components =
      static_cast<std::size_t>(tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(type)));
  std::vector<double> numbers;
  if (accessor.bufferView >= 0) {
    const Elements elements = find(index, accessor.bufferView, accessor.byteOffset, accessor.count,
                                   accessor.componentType, components);
    numbers.reserve(accessor.count * components);
    for (std::size_t i = 0; i < accessor.count; ++i) {
      for (std::size_t c = 0; c < components; ++c) numbers.push_back(elements.at(i, c));
    }
  } else {
    numbers.assign(accessor.count * components, 0);  // the format's rule, for arrays that are all sparse
  }
  if (accessor.sparse.isSparse) apply_sparse(index, components, numbers);
  if (accessor.normalized) {
    const double divisor = normal_divisor(accessor.componentType);
    for (double& number : numbers) number = std::max(number / divisor, -1.0);  // -128 is -1, as -127 is
  }
  return numbers;
}

void GltfArrays::apply_sparse(int index, std::size_t components, std::vector<double>& numbers) const {
  const tinygltf::Accessor& accessor = gltf_.model.accessors[static_cast<std::size_t>(index)];
  const auto& sparse = accessor.sparse;
  if (sparse.count < 0 || sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0) {
    fail(index, "has a negative number in its sparse part");
  }
  const auto count = static_cast<std::size_t>(sparse.count);
  const Elements places =
      find(index, sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset), count,
           sparse.indices.componentType, 1);
  const Elements values =
      find(index, sparse.values.bufferView, static_cast<std::size_t>(sparse.values.byteOffset), count,
           accessor.componentType, components);
  for (std::size_t i = 0; i < count; ++i) {
    const double place = places.at(i, 0);
    if (!(place >= 0 && place < static_cast<double>(accessor.count)) || place != std::floor(place)) {
      fail(index, "its sparse part replaces an element that is not there");
    }
    for (std::size_t c = 0; c < components; ++c) {
      numbers[static_cast<std::size_t>(place) * components + c] = values.at(i, c);
    }
  }
}

std::vector<Vec3> GltfArrays::positions(int accessor) {
  const std::vector<double> coordinates = numbers(accessor, TINYGLTF_TYPE_VEC3);
  std::vector<Vec3> positions;
  positions.reserve(coordinates.size() / 3);
  for (std::size_t i = 0; i < coordinates.size(); i += 3) {
    positions.emplace_back(coordinates[i], coordinates[i + 1], coordinates[i + 2]);
    if (!positions.back().allFinite()) fail(accessor, "a coordinate is not a finite number");
  }
  return positions;
}

std::vector<std::uint32_t> GltfArrays::indices(int accessor) {
  std::vector<std::uint32_t> indices;
  for (const double number : numbers(accessor, TINYGLTF_TYPE_SCALAR)) {
    if (!(number >= 0 && number <= 0xFFFFFFFFp0) || number != std::floor(number)) {
      fail(accessor, "an index is not a whole number of 0 or more");
    }
    indices.push_back(static_cast<std::uint32_t>(number));
  }
  return indices;
}

}  // namespace archetype
