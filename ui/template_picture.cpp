#include "ui/template_picture.h"

#include <algorithm>
#include <array>
#include <vector>

#include "core/report/box_faces.h"

namespace archetype {
namespace {

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

void draw_faces(ImDrawList& draw, const std::vector<BoxFace>& faces, const Placement& place, int opacity) {
  for (const BoxFace& face : faces) {
    std::array<ImVec2, 4> at;
    for (std::size_t i = 0; i < at.size(); ++i) at[i] = place(face.corners[i]);
    // Dear ImGui smooths the rims of what goes clockwise only.
    const float turn = (at[2].x - at[0].x) * (at[3].y - at[1].y) - (at[2].y - at[0].y) * (at[3].x - at[1].x);
    if (turn < 0) std::ranges::reverse(at);
    if (face.rare) {
      draw.AddQuad(at[0], at[1], at[2], at[3],
                   IM_COL32(face.colour[0], face.colour[1], face.colour[2], opacity / 2));
      continue;
    }
    draw.AddQuadFilled(at[0], at[1], at[2], at[3],
                       IM_COL32(face.colour[0], face.colour[1], face.colour[2], opacity));
    draw.AddQuad(at[0], at[1], at[2], at[3], IM_COL32(0, 0, 0, 90));
  }
}

void add_corners(Bounds& extent, const std::vector<BoxFace>& faces) {
  for (const BoxFace& face : faces)
    for (const Vec3& corner : face.corners) extent.add(corner);
}

}  // namespace

void draw_template_picture(ImDrawList& draw, const PartTemplate& part_template, ImVec2 low, float side) {
  const std::vector<BoxFace> faces = visible_faces(coloured_boxes(part_template));
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
  const std::vector<BoxFace> faces = visible_faces(boxes);
  struct Dot {
    Vec3 at;
    Rgb colour;
  };
  const Mat3 view = picture_view();
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
