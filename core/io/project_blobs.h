// The binary values of a project file: little-endian, a version byte first. Whoever reads them trusts
// nothing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <vector>

#include "core/base/hash.h"
#include "core/model/shape.h"
#include "core/model/shape_fit.h"

namespace archetype {

// What is wrong with a blob; the caller adds the file and whose blob it is.
class BadBlob : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

using Blob = std::vector<std::byte>;
using BlobView = std::span<const std::byte>;

Blob encode_hash(const ContentHash& hash);
ContentHash decode_hash(BlobView blob);

Blob encode_frame(const ShapeFrame& frame);
ShapeFrame decode_frame(BlobView blob);  // finite, a rotation, scale > 0

// Coordinates and features are kept as 32-bit floats. The frame is stored with the shape.
Blob encode_samples(const ShapeSamples& samples);
ShapeSamples decode_samples(BlobView blob, std::size_t element_count);  // every face < element_count

Blob encode_fit(const ShapeFit& fit);
ShapeFit decode_fit(BlobView blob, std::size_t part_count, std::size_t sample_count);

Blob encode_labels(std::span<const std::int16_t> labels);
std::vector<std::int16_t> decode_labels(BlobView blob, std::size_t part_count, std::size_t element_count);

}  // namespace archetype
