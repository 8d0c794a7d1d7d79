#include "tests/support/big_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "core/base/number_text.h"
#include "core/generate/generate.h"
#include "core/io/file.h"

namespace archetype::test {

namespace {

// The faces as n x n quads each. Points of shared edges come out the same from both sides.
PolygonMesh finer(const PolygonMesh& mesh, std::uint32_t n) {
  PolygonMesh result;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    const auto corner = [&](std::size_t i) { return mesh.vertices[face[std::min(i, face.size() - 1)]]; };
    const auto first = static_cast<std::uint32_t>(result.vertices.size());
    for (std::uint32_t j = 0; j <= n; ++j) {
      for (std::uint32_t i = 0; i <= n; ++i) {
        result.vertices.emplace_back((corner(0) * ((n - i) * (n - j)) + corner(1) * (i * (n - j)) +
                                      corner(2) * (i * j) + corner(3) * ((n - i) * j)) /
                                     (n * n));
      }
    }
    for (std::uint32_t j = 0; j < n; ++j) {
      for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t at = first + j * (n + 1) + i;
        result.add_face(std::array{at, at + 1, at + n + 2, at + n + 1});
      }
    }
  }
  return result;
}

}  // namespace

void write_big_chair(const std::filesystem::path& folder, std::size_t faces) {
  GenerateOptions options;
  options.count = 1;
  write_collection("chairs", options, folder, {});
  const GeneratedShape chair = generate_shape("chairs", options, 0);
  const auto cuts = static_cast<std::uint32_t>(
      std::ceil(std::sqrt(static_cast<double>(faces) / static_cast<double>(chair.mesh.face_count()))));
  const PolygonMesh mesh = finer(chair.mesh, cuts);
  std::ostringstream off;
  off << "OFF\n" << mesh.vertices.size() << ' ' << mesh.face_count() << " 0\n";
  for (const Vec3& v : mesh.vertices)
    off << number_text(v.x()) << ' ' << number_text(v.y()) << ' ' << number_text(v.z()) << '\n';
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    off << '4';
    for (const std::uint32_t corner : mesh.face(f)) off << ' ' << corner;
    off << '\n';
  }
  std::ostringstream labels;
  for (const int label : chair.labels) {
    for (std::uint32_t i = 0; i < cuts * cuts; ++i) labels << label << '\n';
  }
  replace_file(folder / "shapes" / (chair.name + ".off"), off.str());
  replace_file(folder / "labels" / (chair.name + ".seg"), labels.str());
}

}  // namespace archetype::test
