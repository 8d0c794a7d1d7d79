#include "core/report/box_faces.h"

#include <algorithm>

namespace archetype {

Mat3 picture_view() {
  return (Mat3() << 0.80, 0, -0.60, -0.23, 0.92, -0.31, 0.55, 0.39, 0.74).finished();
}

Rgb darker(const Rgb& colour, double share) {
  Rgb result{};
  for (std::size_t k = 0; k < colour.size(); ++k) result[k] = static_cast<std::uint8_t>(share * colour[k]);
  return result;
}

bool is_rare(const TemplatePart& part) {
  return !part.must_exist && part.existence < 0.5;
}

std::vector<ColouredBox> coloured_boxes(const PartTemplate& part_template) {
  std::vector<ColouredBox> boxes;
  for (std::size_t k = 0; k < part_template.parts.size(); ++k)
    boxes.push_back({part_template.parts[k].mean_box(), part_colour(part_template, static_cast<int>(k)),
                     is_rare(part_template.parts[k])});
  return boxes;
}

std::vector<BoxFace> visible_faces(std::span<const ColouredBox> boxes) {
  const Mat3 view = picture_view();
  std::vector<BoxFace> faces;
  for (const auto& [box, colour, rare] : boxes) {
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 normal = view * (box.orientation * Vec3::Unit(axis));
      const double side = normal.z() > 0 ? 1 : -1;
      BoxFace face;
      for (int corner = 0; corner < 4; ++corner) {
        Vec3 local;
        local[axis] = side;
        local[(axis + 1) % 3] = corner == 0 || corner == 3 ? -1 : 1;
        local[(axis + 2) % 3] = corner < 2 ? -1 : 1;
        Vec3& at = face.corners[static_cast<std::size_t>(corner)] = view * box.to_world(local);
        face.depth += at.z() / 4;
      }
      face.colour = darker(colour, 0.6 + 0.4 * std::max(0.0, side * normal.dot(Vec3(0.2, 0.8, 0.55))));
      face.rare = rare;
      faces.push_back(face);
    }
  }
  std::ranges::stable_sort(faces, {}, &BoxFace::depth);
  return faces;
}

}  // namespace archetype
