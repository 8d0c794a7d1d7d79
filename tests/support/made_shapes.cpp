// Boxes around ground-truth parts.
#include "tests/support/made_shapes.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace archetype::test {

PartTemplate template_from(const MadeShape& shape) {
  const PolygonMesh& mesh = shape.generated.mesh;
  std::vector<std::uint32_t> piece(mesh.vertices.size());
  std::iota(piece.begin(), piece.end(), 0U);
  const auto find = [&](std::uint32_t v) {
    while (piece[v] != v) v = piece[v] = piece[piece[v]];
    return v;
  };
  // Vertices of one label that share a face are one piece; solids of different labels share no vertices.
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    for (const auto c : mesh.face(f)) piece[find(c)] = find(mesh.face(f)[0]);
  }
  std::map<std::uint32_t, std::pair<int, Bounds>> parts;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    auto& [label, bounds] = parts[find(mesh.face(f)[0])];
    label = shape.generated.labels[f];
    for (const auto c : mesh.face(f)) bounds.add(shape.samples.frame.to_normalised(mesh.vertices[c]));
  }
  PartTemplate result;
  result.name = shape.generated.name;
  for (const auto& [piece_of, part] : parts) {
    TemplatePart p;
    p.label = part.first;
    p.name = "part " + std::to_string(result.parts.size());
    p.position = {part.second.centre(), Vec3::Constant(0.2)};
    p.scale = {part.second.half_extent().cwiseMax(0.02), Vec3::Constant(0.1)};
    p.existence = 0.9;
    result.parts.push_back(p);
  }
  return result;
}

double label_accuracy(const MadeShape& shape, const PartTemplate& part_template,
                      const std::vector<std::int16_t>& parts) {
  double right = 0;
  double all = 0;
  for (std::size_t f = 0; f < parts.size(); ++f) {
    const double area = face_area_vector(shape.generated.mesh, f).norm();
    all += area;
    const bool labelled = parts[f] >= 0;
    if (labelled &&
        part_template.parts[static_cast<std::size_t>(parts[f])].label == shape.generated.labels[f]) {
      right += area;
    }
  }
  return right / all;
}

}  // namespace archetype::test
