// Encodes and decodes the binary values of a project file.
#include "core/io/project_blobs.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <string>

namespace archetype {

namespace {

constexpr std::uint8_t blob_version = 1;
constexpr std::size_t most_samples = 1'000'000;
constexpr double largest = 1e30;  // coordinates beyond are nothing that a computation could go on with

class Writer {
 public:
  Writer() { integer<std::uint8_t>(blob_version); }

  template <class Integer>
  void integer(Integer value) {
    const auto bits = static_cast<std::uint64_t>(value);
    for (std::size_t i = 0; i < sizeof(Integer); ++i)
      blob_.push_back(static_cast<std::byte>(bits >> (8 * i)));
  }
  void real(double value) { integer(std::bit_cast<std::uint64_t>(value)); }
  void small_real(double value) { integer(std::bit_cast<std::uint32_t>(static_cast<float>(value))); }
  void vector(const Vec3& v) {
    std::for_each(v.begin(), v.end(), [&](double x) { real(x); });
  }
  void small_vector(const Vec3& v) {
    std::for_each(v.begin(), v.end(), [&](double x) { small_real(x); });
  }
  void reserve(std::size_t bytes) { blob_.reserve(bytes); }
  Blob take() { return std::move(blob_); }

 private:
  Blob blob_;
};

class Reader {
 public:
  explicit Reader(BlobView blob) : rest_(blob) {
    const auto version = integer<std::uint8_t>();
    if (version != blob_version) throw BadBlob("its version is " + std::to_string(version) + ", not 1");
  }

  template <class Integer>
  Integer integer() {
    if (rest_.size() < sizeof(Integer)) throw BadBlob("it ends too early");
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < sizeof(Integer); ++i) {
      bits |= std::to_integer<std::uint64_t>(rest_[i]) << (8 * i);
    }
    rest_ = rest_.subspan(sizeof(Integer));
    return static_cast<Integer>(bits);
  }
  double any_real() { return std::bit_cast<double>(integer<std::uint64_t>()); }
  double real() { return checked(any_real()); }
  double small_real() { return checked(std::bit_cast<float>(integer<std::uint32_t>())); }
  Vec3 vector() {
    const double x = real();
    const double y = real();
    return {x, y, real()};
  }
  Vec3 small_vector() {
    const double x = small_real();
    const double y = small_real();
    return {x, y, small_real()};
  }
  // A count of items of `bytes_each` that follow, which the blob must be long enough for.
  std::size_t count(std::size_t most, std::size_t bytes_each) {
    const auto value = integer<std::uint32_t>();
    if (value > most || value > rest_.size() / bytes_each) {
      throw BadBlob("it promises " + std::to_string(value) + " entries");
    }
    return value;
  }
  std::int16_t label(std::size_t part_count) {
    const auto value = integer<std::int16_t>();
    if (value < null_label || (value >= 0 && static_cast<std::size_t>(value) >= part_count)) {
      throw BadBlob("it names part " + std::to_string(value));
    }
    return value;
  }
  void end() const {
    if (!rest_.empty()) throw BadBlob("it goes on after its end");
  }

 private:
  static double checked(double value) {
    if (!(std::abs(value) <= largest)) throw BadBlob("it has a number that is not finite");
    return value;
  }
  BlobView rest_;
};

void check_size(std::size_t found, std::size_t expected, const char* what) {
  if (found != expected) {
    throw BadBlob("it has " + std::to_string(found) + " " + what + ", not " + std::to_string(expected));
  }
}

void write_features(Writer& out, const std::vector<Features>& features) {
  for (const Features& f : features) std::for_each(f.begin(), f.end(), [&](double x) { out.small_real(x); });
}

std::vector<Features> read_features(Reader& in, std::size_t count) {
  std::vector<Features> features(count);
  for (Features& f : features) std::generate(f.begin(), f.end(), [&] { return in.small_real(); });
  return features;
}

std::vector<Vec3> read_vectors(Reader& in, std::size_t count) {
  std::vector<Vec3> vectors(count);
  for (Vec3& v : vectors) v = in.small_vector();
  return vectors;
}

void write_part(Writer& out, const FittedPart& part) {
  out.integer(static_cast<std::uint8_t>((part.present ? 1 : 0) + 2 * static_cast<int>(part.box.solid)));
  out.vector(part.box.centre);
  out.vector(part.box.half_extent);
  const Eigen::Vector4d& q = part.box.orientation.coeffs();
  std::for_each(q.begin(), q.end(), [&](double x) { out.real(x); });
}

FittedPart read_part(Reader& in) {
  FittedPart part;
  const auto state = in.integer<std::uint8_t>();  // versions without solids wrote 0 or 1
  if (state / 2 > static_cast<int>(Solid::ellipsoid)) throw BadBlob("it has a solid that is none");
  part.present = state % 2 != 0;
  part.box.solid = static_cast<Solid>(state / 2);
  part.box.centre = in.vector();
  part.box.half_extent = in.vector();
  Eigen::Vector4d q;
  std::generate(q.begin(), q.end(), [&] { return in.real(); });
  part.box.orientation.coeffs() = q;
  if (!(part.box.half_extent.minCoeff() > 0)) throw BadBlob("it has a box without extent");
  if (!(std::abs(q.norm() - 1) < 1e-6)) throw BadBlob("it has an orientation that is no rotation");
  return part;
}

}  // namespace

Blob encode_hash(const ContentHash& hash) {
  Writer out;
  for (const std::uint64_t word : hash.words) out.integer(word);
  return out.take();
}

ContentHash decode_hash(BlobView blob) {
  Reader in(blob);
  ContentHash hash;
  for (std::uint64_t& word : hash.words) word = in.integer<std::uint64_t>();
  in.end();
  return hash;
}

Blob encode_frame(const ShapeFrame& frame) {
  Writer out;
  for (int row = 0; row < 3; ++row) out.vector(frame.rotation.row(row).transpose());
  out.vector(frame.centroid);
  out.real(frame.scale);
  return out.take();
}

ShapeFrame decode_frame(BlobView blob) {
  Reader in(blob);
  ShapeFrame frame;
  for (int row = 0; row < 3; ++row) frame.rotation.row(row) = in.vector().transpose();
  frame.centroid = in.vector();
  frame.scale = in.real();
  in.end();
  const Mat3& r = frame.rotation;
  if (!(r * r.transpose()).isIdentity(1e-9) || !(r.determinant() > 0)) throw BadBlob("its rotation is none");
  if (!(frame.scale > 0)) throw BadBlob("its scale is not positive");
  return frame;
}

Blob encode_samples(const ShapeSamples& samples) {
  Writer out;
  out.reserve(5 + samples.size() * (6 + 1 + 2 * feature_count) * sizeof(float));
  out.integer(static_cast<std::uint32_t>(samples.size()));
  for (const Vec3& p : samples.points) out.small_vector(p);
  for (const Vec3& n : samples.normals) out.small_vector(n);
  for (const std::uint32_t face : samples.faces) out.integer(face);
  write_features(out, samples.features_x);
  write_features(out, samples.features_z);
  return out.take();
}

ShapeSamples decode_samples(BlobView blob, std::size_t element_count) {
  Reader in(blob);
  const std::size_t count = in.count(most_samples, (6 + 1 + 2 * feature_count) * sizeof(float));
  if (count == 0) throw BadBlob("it has no samples");
  ShapeSamples samples;
  samples.points = read_vectors(in, count);
  samples.normals = read_vectors(in, count);
  samples.faces.resize(count);
  for (std::uint32_t& face : samples.faces) {
    face = in.integer<std::uint32_t>();
    if (face >= element_count) throw BadBlob("it has a sample on face " + std::to_string(face));
  }
  samples.features_x = read_features(in, count);
  samples.features_z = read_features(in, count);
  in.end();
  return samples;
}

Blob encode_fit(const ShapeFit& fit) {
  Writer out;
  out.vector(fit.translation);
  out.integer(static_cast<std::int32_t>(fit.alternations));
  out.integer<std::uint8_t>(fit.converged ? 1 : 0);
  for (const double energy : fit.yaw_energies) out.real(energy);
  out.integer(static_cast<std::uint32_t>(fit.parts.size()));
  for (const FittedPart& part : fit.parts) write_part(out, part);
  out.integer(static_cast<std::uint32_t>(fit.labels.size()));
  for (const std::int16_t label : fit.labels) out.integer(label);
  return out.take();
}

ShapeFit decode_fit(BlobView blob, std::size_t part_count, std::size_t sample_count) {
  constexpr std::size_t part_bytes = 1 + 10 * sizeof(double);
  Reader in(blob);
  ShapeFit fit;
  fit.translation = in.vector();
  fit.alternations = in.integer<std::int32_t>();
  fit.converged = in.integer<std::uint8_t>() != 0;
  for (double& energy : fit.yaw_energies) {
    energy = in.any_real();
    if (std::isnan(energy)) throw BadBlob("it has an energy that is no number");
  }
  const std::size_t parts = in.count(std::numeric_limits<std::int16_t>::max(), part_bytes);
  check_size(parts, part_count, "parts");
  for (std::size_t i = 0; i < parts; ++i) fit.parts.push_back(read_part(in));
  const std::size_t labels = in.count(most_samples, sizeof(std::int16_t));
  check_size(labels, sample_count, "labels");
  for (std::size_t i = 0; i < labels; ++i) fit.labels.push_back(in.label(part_count));
  in.end();
  return fit;
}

Blob encode_labels(std::span<const std::int16_t> labels) {
  Writer out;
  out.reserve(5 + labels.size_bytes());
  out.integer(static_cast<std::uint32_t>(labels.size()));
  for (const std::int16_t label : labels) out.integer(label);
  return out.take();
}

std::vector<std::int16_t> decode_labels(BlobView blob, std::size_t part_count, std::size_t element_count) {
  Reader in(blob);
  const std::size_t count = in.count(std::numeric_limits<std::uint32_t>::max(), sizeof(std::int16_t));
  check_size(count, element_count, "labels");
  std::vector<std::int16_t> labels(count);
  for (std::int16_t& label : labels) label = in.label(part_count);
  in.end();
  return labels;
}

}  // namespace archetype
