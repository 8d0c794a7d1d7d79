#include "ui/template_picture.h"

#include <algorithm>
#include <array>
#include <vector>

#include "core/model/part_colours.h"

namespace archetype {
namespace {

// From the front, right and above, as the grid shows shapes.
const Mat3 view = (Mat3() << 0.85, 0, -0.53, -0.2, 0.92, -0.33, 0.49, 0.39, 0.78).finished();

struct ColouredBox {
  Box box;
  Rgb colour;
};

struct Face {
  double depth = 0;
  std::array<Vec3, 4> corners;  // seen from the view
  Rgb colour{};
};

// The faces of the boxes that look at the viewer, the farthest first.
std::vector<Face> visible_faces(const std::vector<ColouredBox>& boxes) {
  std::vector<Face> faces;
  for (const auto& [box, colour] : boxes) {
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 normal = view * (box.orientation * Vec3::Unit(axis));
      const double side = normal.z() > 0 ? 1 : -1;
      const double light = 0.55 + 0.45 * std::max(0.0, side * normal.dot(Vec3(0.2, 0.8, 0.55)));
      Face face;
      for (int corner = 0; corner < 4; ++corner) {
        Vec3 local;
        local[axis] = side;
        local[(axis + 1) % 3] = corner == 0 || corner == 3 ? -1 : 1;
        local[(axis + 2) % 3] = corner < 2 ? -1 : 1;
        face.corners[static_cast<std::size_t>(corner)] = view * box.to_world(local);
        face.depth += face.corners[static_cast<std::size_t>(corner)].z() / 4;
      }
      for (std::size_t c = 0; c < colour.size(); ++c)
        face.colour[c] = static_cast<std::uint8_t>(colour[c] * light);
      faces.push_back(face);
    }
  }
  std::ranges::stable_sort(faces, {}, &Face::depth);
  return faces;
}

// From the view into the square.
struct Placement {
  Vec3 centre = Vec3::Zero();
  double scale = 1;
  ImVec2 middle;
  ImVec2 operator()(const Vec3& p) const {
    const Vec3 from_middle = scale * (p - centre);
    return {middle.x + static_cast<float>(from_middle.x()), middle.y - static_cast<float>(from_middle.y())};
  }
};

Placement placement(const Bounds& extent, ImVec2 low, float side) {
  const Vec3 half = extent.half_extent();
  return {extent.centre(),
          0.46 * side / std::max({half.x(), half.y(), 1e-6}),
          {low.x + side / 2, low.y + side / 2}};
}

void draw_faces(ImDrawList& draw, const std::vector<Face>& faces, const Placement& place, int opacity) {
  for (const Face& face : faces) {
    std::array<ImVec2, 4> at;
    for (std::size_t i = 0; i < at.size(); ++i) at[i] = place(face.corners[i]);
    draw.AddQuadFilled(at[0], at[1], at[2], at[3],
                       IM_COL32(face.colour[0], face.colour[1], face.colour[2], opacity));
    draw.AddQuad(at[0], at[1], at[2], at[3], IM_COL32(0, 0, 0, 90));
  }
}

void add_corners(Bounds& extent, const std::vector<Face>& faces) {
  for (const Face& face : faces)
    for (const Vec3& corner : face.corners) extent.add(corner);
}

}  // namespace

void draw_template_picture(ImDrawList& draw, const PartTemplate& part_template, ImVec2 low, float side) {
  std::vector<ColouredBox> boxes;
  for (std::size_t k = 0; k < part_template.parts.size(); ++k)
    boxes.push_back({part_template.parts[k].mean_box(), part_colour(part_template, static_cast<int>(k))});
  const std::vector<Face> faces = visible_faces(boxes);
  if (faces.empty()) return;
  Bounds extent;
  add_corners(extent, faces);
  draw_faces(draw, faces, placement(extent, low, side), 235);
}

void draw_fit_picture(ImDrawList& draw, const ShapeFit& fit, const ShapeSamples& samples, ImVec2 low,
                      float side) {
  std::vector<ColouredBox> boxes;
  for (std::size_t k = 0; k < fit.parts.size(); ++k)
    if (fit.parts[k].present) boxes.push_back({fit.parts[k].box, part_colour(static_cast<int>(k))});
  const std::vector<Face> faces = visible_faces(boxes);
  struct Dot {
    Vec3 at;
    Rgb colour;
  };
  std::vector<Dot> dots;
  for (std::size_t i = 0; i < samples.points.size() && i < fit.labels.size(); ++i)
    dots.push_back({view * fit.to_template(samples.points[i]), part_colour(fit.labels[i])});
  std::ranges::stable_sort(dots, {}, [](const Dot& dot) { return dot.at.z(); });
  if (dots.empty()) return;
  Bounds extent;
  add_corners(extent, faces);
  for (const Dot& dot : dots) extent.add(dot.at);
  const Placement place = placement(extent, low, side);
  draw_faces(draw, faces, place, 45);
  const float half = std::max(1.0f, side / 130);
  for (const Dot& dot : dots) {
    const ImVec2 at = place(dot.at);
    draw.AddRectFilled({at.x - half, at.y - half}, {at.x + half, at.y + half},
                       IM_COL32(dot.colour[0], dot.colour[1], dot.colour[2], 255));
  }
}

}  // namespace archetype
