#include "core/report/template_svg.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "core/model/part_colours.h"

namespace archetype {
namespace {

// From the front, right and above, as the window shows shapes first.
const Mat3 view = (Mat3() << 0.80, 0, -0.60, -0.23, 0.92, -0.31, 0.55, 0.39, 0.74).finished();

struct Face {
  double depth = 0;
  std::array<Vec3, 4> corners;
  Rgb colour{};
};

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

Rgb darker(const Rgb& colour, double share) {
  Rgb result{};
  for (std::size_t k = 0; k < 3; ++k) result[k] = static_cast<std::uint8_t>(share * colour[k]);
  return result;
}

std::vector<Face> faces_of(const PartTemplate& part_template) {
  std::vector<Face> faces;
  for (std::size_t i = 0; i < part_template.parts.size(); ++i) {
    const Box box = part_template.parts[i].mean_box();
    const Rgb colour = part_colour(part_template, static_cast<int>(i));
    for (int axis = 0; axis < 3; ++axis)
      for (const double side : {-1.0, 1.0}) {
        const Vec3 normal = view * (box.orientation * Vec3(side * Vec3::Unit(axis)));
        if (normal.z() <= 0) continue;  // seen from behind
        Face face;
        for (int corner = 0; corner < 4; ++corner) {
          Vec3 local;
          local[axis] = side;
          local[(axis + 1) % 3] = corner == 0 || corner == 3 ? -1 : 1;
          local[(axis + 2) % 3] = corner < 2 ? -1 : 1;
          Vec3& at = face.corners[static_cast<std::size_t>(corner)] = view * box.to_world(local);
          face.depth += at.z() / 4;
        }
        face.colour = darker(colour, 0.72 + 0.28 * std::max(0.0, normal.dot(Vec3(0.2, 0.8, 0.55))));
        faces.push_back(face);
      }
  }
  std::ranges::stable_sort(faces, {}, &Face::depth);
  return faces;
}

Placement placement(const std::vector<Face>& faces, int side) {
  Bounds bounds;
  for (const Face& face : faces)
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
  const std::vector<Face> faces = faces_of(part_template);
  const Placement place = placement(faces, side);
  const std::string size = std::to_string(side);
  std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + size + "\" height=\"" + size +
                    "\" viewBox=\"0 0 " + size + ' ' + size + "\">\n";
  for (const Face& face : faces) {
    svg += "<polygon points=\"";
    for (const Vec3& corner : face.corners)
      svg += number(place.x(corner)) + ',' + number(place.y(corner)) + ' ';
    svg += "\" fill=\"" + hex(face.colour) + "\" fill-opacity=\"0.45\" stroke=\"" +
           hex(darker(face.colour, 0.75)) + "\" stroke-width=\"1.2\" stroke-linejoin=\"round\"/>\n";
  }
  for (std::size_t i = 0; i < part_template.parts.size(); ++i) {
    const Rgb colour = part_colour(part_template, static_cast<int>(i));
    svg += spread_ellipse(part_template.parts[i], colour, place);
    svg += spread_lines(part_template.parts[i], colour, place);
  }
  return svg + "</svg>\n";
}

}  // namespace archetype
