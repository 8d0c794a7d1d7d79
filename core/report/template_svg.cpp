#include "core/report/template_svg.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "core/report/box_faces.h"

namespace archetype {
namespace {

struct Placement {
  Vec3 middle = Vec3::Zero();
  double scale = 1;
  double half = 0;
  double x(const Vec3& p) const { return half + scale * (p.x() - middle.x()); }
  double y(const Vec3& p) const { return half - scale * (p.y() - middle.y()); }
};

std::string number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1f", std::isfinite(value) ? std::clamp(value, -1e5, 1e5) : 0);
  return text.data();
}

std::string hex(const Rgb& colour) {
  std::array<char, 8> text{};
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", colour[0], colour[1], colour[2]);
  return text.data();
}

Placement placement(const std::vector<BoxFace>& faces, int side) {
  Bounds bounds;
  for (const BoxFace& face : faces)
    for (const Vec3& corner : face.corners)
      if (corner.allFinite()) bounds.add(corner);
  Placement place;
  place.half = 0.5 * side;
  if (bounds.empty()) return place;
  place.middle = 0.5 * (bounds.low + bounds.high);
  const Vec3 size = bounds.high - bounds.low;
  place.scale = 0.9 * side / std::max({size.x(), size.y(), 1e-6});
  return place;
}

// What is seen of the ellipsoid of one standard deviation: the covariance of the position, projected.
std::string spread_ellipse(const TemplatePart& part, const Rgb& colour, const Placement& place) {
  const Mat3 view = picture_view();
  const Mat3 covariance = view * part.position.stddev.cwiseAbs2().asDiagonal() * view.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(covariance.topLeftCorner<2, 2>());
  const Eigen::Vector2d radii = axes.eigenvalues().cwiseMax(0).cwiseSqrt() * place.scale;
  const Eigen::Vector2d along = axes.eigenvectors().col(1);
  const double degrees = -std::atan2(along.y(), along.x()) * 180 / 3.14159265358979;
  const Vec3 at = view * part.position.mean;
  const std::string x = number(place.x(at));
  const std::string y = number(place.y(at));
  return "<ellipse cx=\"" + x + "\" cy=\"" + y + "\" rx=\"" + number(radii[1]) + "\" ry=\"" +
         number(radii[0]) + "\" transform=\"rotate(" + number(degrees) + ' ' + x + ' ' + y + ")\" fill=\"" +
         hex(colour) + "\" fill-opacity=\"0.35\"/>\n";
}

std::string spread_lines(const TemplatePart& part, const Rgb& colour, const Placement& place) {
  const Mat3 view = picture_view();
  std::string lines;
  for (int k = 0; k < 3; ++k)
    for (const double side : {-1.0, 1.0}) {
      const Vec3 out = part.orientation * Vec3(side * Vec3::Unit(k));
      const double inner = std::max(part.scale.mean[k] - part.scale.stddev[k], 0.0);
      const Vec3 from = view * Vec3(part.position.mean + inner * out);
      const Vec3 to = view * Vec3(part.position.mean + (part.scale.mean[k] + part.scale.stddev[k]) * out);
      lines += "<line x1=\"" + number(place.x(from)) + "\" y1=\"" + number(place.y(from)) + "\" x2=\"" +
               number(place.x(to)) + "\" y2=\"" + number(place.y(to)) + "\" stroke=\"" +
               hex(darker(colour, 0.7)) + "\" stroke-width=\"1.2\" stroke-dasharray=\"3 3\"/>\n";
    }
  return lines;
}

}  // namespace

std::string template_svg(const PartTemplate& part_template, int side) {
  const std::vector<BoxFace> faces = visible_faces(coloured_boxes(part_template));
  const Placement place = placement(faces, side);
  const std::string size = std::to_string(side);
  std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + size + "\" height=\"" + size +
                    "\" viewBox=\"0 0 " + size + ' ' + size + "\">\n";
  for (const BoxFace& face : faces) {
    svg += "<polygon points=\"";
    for (const Vec3& corner : face.corners)
      svg += number(place.x(corner)) + ',' + number(place.y(corner)) + ' ';
    const std::string stroke =
        "\" stroke=\"" + hex(darker(face.colour, 0.75)) + "\" stroke-linejoin=\"round\"";
    if (face.rare)
      svg += "\" fill=\"none" + stroke + " stroke-width=\"0.8\" stroke-dasharray=\"2 3\"/>\n";
    else
      svg +=
          "\" fill=\"" + hex(face.colour) + "\" fill-opacity=\"0.45" + stroke + " stroke-width=\"1.2\"/>\n";
  }
  for (std::size_t i = 0; i < part_template.parts.size(); ++i) {
    if (is_rare(part_template.parts[i])) continue;
    const Rgb colour = part_colour(part_template, static_cast<int>(i));
    svg += spread_ellipse(part_template.parts[i], colour, place);
    svg += spread_lines(part_template.parts[i], colour, place);
  }
  return svg + "</svg>\n";
}

}  // namespace archetype
