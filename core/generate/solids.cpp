// Closed solids with one label per face.
#include "core/generate/solids.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <Eigen/Geometry>

#include "core/base/error.h"

namespace archetype {

namespace {

constexpr double pi = std::numbers::pi;

std::uint32_t add_vertex(Assembly& assembly, const Vec3& p) {
  assembly.mesh.vertices.push_back(p);
  return static_cast<std::uint32_t>(assembly.mesh.vertices.size() - 1);
}

void add_face(Assembly& assembly, int label, std::initializer_list<std::uint32_t> corners) {
  assembly.mesh.add_face(std::span(corners.begin(), corners.size()));
  assembly.labels.push_back(label);
}

// A fan over the ring that starts at vertex `first`; `forward` where the ring runs counter-clockwise seen
// from outside.
void add_cap(Assembly& assembly, int label, const Ring& ring, std::uint32_t first, bool forward) {
  Vec3 middle = Vec3::Zero();
  for (const Vec3& p : ring) middle += p;
  const auto n = static_cast<std::uint32_t>(ring.size());
  const std::uint32_t centre = add_vertex(assembly, middle / static_cast<double>(n));
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t a = first + i;
    const std::uint32_t b = first + (i + 1) % n;
    add_face(assembly, label, {centre, forward ? a : b, forward ? b : a});
  }
}

// Two unit vectors with u × v = axis (a unit vector).
std::pair<Vec3, Vec3> perpendicular(const Vec3& axis) {
  const Vec3 helper = std::abs(axis.x()) < 0.9 ? Vec3::UnitX() : Vec3::UnitY();
  const Vec3 v = (helper - helper.dot(axis) * axis).normalized();
  return {v.cross(axis), v};
}

// Grid lines of a rounded block along one axis: its ends, the ends of its flat side, and the cells between
// them.
std::vector<double> grid_lines(double half, double bevel, int cells) {
  std::vector<double> lines;
  if (bevel > 0) lines.push_back(-half);
  const double flat = half - bevel;
  for (int i = 0; i <= cells; ++i) lines.push_back(flat * (2.0 * i / cells - 1.0));
  if (bevel > 0) lines.push_back(half);
  return lines;
}

}  // namespace

Profile superellipse(double radius_x, double radius_y, double exponent, int sides) {
  Profile profile;
  const auto bent = [&](double c) { return std::copysign(std::pow(std::abs(c), 2.0 / exponent), c); };
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * pi * (i + 0.5) / sides;
    profile.emplace_back(radius_x * bent(std::cos(angle)), radius_y * bent(std::sin(angle)));
  }
  return profile;
}

Profile ellipse(double radius_x, double radius_y, int sides) {
  return superellipse(radius_x, radius_y, 2, sides);
}

Profile rounded_rectangle(double half_x, double half_y, double radius, int corner_segments) {
  radius = std::min({radius, 0.98 * half_x, 0.98 * half_y});
  Profile profile;
  for (int corner = 0; corner < 4; ++corner) {
    const double sign_x = corner == 0 || corner == 3 ? 1 : -1;
    const double sign_y = corner < 2 ? 1 : -1;
    for (int i = 0; i <= corner_segments; ++i) {
      const double angle = 0.5 * pi * (corner + static_cast<double>(i) / corner_segments);
      profile.emplace_back(sign_x * (half_x - radius) + radius * std::cos(angle),
                           sign_y * (half_y - radius) + radius * std::sin(angle));
    }
  }
  return profile;
}

Profile wing_section(double chord, double thickness_share, int points_per_side) {
  const auto half_thickness = [&](double x) {
    return 5 * thickness_share * chord *
           (0.2969 * std::sqrt(x) - 0.126 * x - 0.3516 * x * x + 0.2843 * x * x * x - 0.1036 * x * x * x * x);
  };
  Profile profile;
  // Nose to tail over the top, back below; cosine spacing puts points where the curvature is.
  for (int i = 0; i < 2 * points_per_side; ++i) {
    const double x = 0.5 * (1 - std::cos(pi * i / points_per_side));
    const double y = half_thickness(x) * (i <= points_per_side ? 1 : -1);
    profile.emplace_back(chord * (0.5 - x), y);
  }
  return profile;
}

Ring place(const Profile& profile, const Vec3& origin, const Vec3& u, const Vec3& v) {
  Ring ring;
  ring.reserve(profile.size());
  for (const Vec2& p : profile) ring.push_back(origin + p.x() * u + p.y() * v);
  return ring;
}

void add_loft(Assembly& assembly, int label, const std::vector<Ring>& rings, LoftEnds ends) {
  if (rings.size() < 2) throw PreconditionError("a loft needs two rings or more");
  const auto first = static_cast<std::uint32_t>(assembly.mesh.vertices.size());
  const auto n = static_cast<std::uint32_t>(rings.front().size());
  for (const Ring& ring : rings) {
    assembly.mesh.vertices.insert(assembly.mesh.vertices.end(), ring.begin(), ring.end());
  }
  const auto count = static_cast<std::uint32_t>(rings.size());
  const std::uint32_t bands = ends == LoftEnds::joined ? count : count - 1;
  for (std::uint32_t k = 0; k < bands; ++k) {
    const std::uint32_t low = first + k * n;
    const std::uint32_t high = first + (k + 1) % count * n;
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t j = (i + 1) % n;
      add_face(assembly, label, {low + i, low + j, high + j, high + i});
    }
  }
  if (ends == LoftEnds::joined) return;
  add_cap(assembly, label, rings.front(), first, false);
  add_cap(assembly, label, rings.back(), first + (count - 1) * n, true);
}

void add_turned(Assembly& assembly, int label, const Vec3& origin, const Vec3& axis, const Profile& outline,
                int sides, LoftEnds ends) {
  const Vec3 direction = axis.normalized();
  const auto [u, v] = perpendicular(direction);
  std::vector<Ring> rings;
  for (const Vec2& p : outline) {
    rings.push_back(place(ellipse(p.x(), p.x(), sides), origin + p.y() * direction, u, v));
  }
  add_loft(assembly, label, rings, ends);
}

void add_tube(Assembly& assembly, int label, const std::vector<Vec3>& path, const std::vector<double>& radii,
              int sides) {
  std::vector<Ring> rings;
  Vec3 u = Vec3::Zero();
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Vec3& before = path[i == 0 ? 0 : i - 1];
    const Vec3& after = path[std::min(i + 1, path.size() - 1)];
    const Vec3 direction = (after - before).normalized();
    // The frame is carried along the path, so that the tube does not twist.
    u = i == 0 ? perpendicular(direction).first : Vec3((u - u.dot(direction) * direction).normalized());
    rings.push_back(place(ellipse(radii[i], radii[i], sides), path[i], u, direction.cross(u)));
  }
  add_loft(assembly, label, rings);
}

void add_tube(Assembly& assembly, int label, const Vec3& from, const Vec3& to, double radius, int sides) {
  add_tube(assembly, label, {from, to}, {radius, radius}, sides);
}

void add_leg(Assembly& assembly, int label, const Vec3& top, const Vec3& foot, const Profile& profile,
             double foot_scale) {
  constexpr int bands = 4;
  std::vector<Ring> rings;
  for (int i = 0; i <= bands; ++i) {
    const double t = static_cast<double>(i) / bands;
    const double scale = foot_scale + (1 - foot_scale) * t;
    rings.push_back(place(profile, foot + t * (top - foot), scale * Vec3::UnitZ(), scale * Vec3::UnitX()));
  }
  add_loft(assembly, label, rings);
}

void add_block(Assembly& assembly, int label, const Vec3& half, double bevel, const std::array<int, 3>& cells,
               const Placement& placement) {
  bevel = std::min(bevel, 0.999 * half.minCoeff());
  std::array<std::vector<double>, 3> lines;
  for (int axis = 0; axis < 3; ++axis) lines[axis] = grid_lines(half[axis], bevel, cells[axis]);
  const Vec3 flat = half - Vec3::Constant(bevel);

  std::map<std::array<int, 3>, std::uint32_t> known;
  const auto corner = [&](const std::array<int, 3>& at_line) {
    const auto [entry, is_new] = known.try_emplace(at_line, 0);
    if (is_new) {
      const Vec3 p(lines[0][at_line[0]], lines[1][at_line[1]], lines[2][at_line[2]]);
      const Vec3 inner = p.cwiseMax(-flat).cwiseMin(flat);
      const Vec3 out = p - inner;
      entry->second = add_vertex(
          assembly, placement(bevel > 0 && out.norm() > 0 ? Vec3(inner + bevel * out.normalized()) : p));
    }
    return entry->second;
  };

  for (int axis = 0; axis < 3; ++axis) {
    const int a = (axis + 1) % 3;
    const int b = (axis + 2) % 3;
    for (const bool high : {false, true}) {
      for (int i = 0; i + 1 < static_cast<int>(lines[a].size()); ++i) {
        for (int j = 0; j + 1 < static_cast<int>(lines[b].size()); ++j) {
          const auto line = [&](int di, int dj) {
            std::array<int, 3> index{};
            index[axis] = high ? static_cast<int>(lines[axis].size()) - 1 : 0;
            index[a] = i + di;
            index[b] = j + dj;
            return corner(index);
          };
          if (high) {
            add_face(assembly, label, {line(0, 0), line(1, 0), line(1, 1), line(0, 1)});
          } else {
            add_face(assembly, label, {line(0, 0), line(0, 1), line(1, 1), line(1, 0)});
          }
        }
      }
    }
  }
}

Placement at(const Vec3& centre) {
  return [centre](const Vec3& p) { return Vec3(centre + p); };
}

Placement along(const Vec3& from, const Vec3& to, const Vec3& up) {
  Mat3 axes;
  axes.col(2) = (to - from).normalized();
  axes.col(0) = up.cross(Vec3(axes.col(2))).normalized();
  axes.col(1) = Vec3(axes.col(2)).cross(Vec3(axes.col(0)));
  const Vec3 middle = 0.5 * (from + to);
  return [axes, middle](const Vec3& p) { return Vec3(middle + axes * p); };
}

void add_mirrored(Assembly& assembly, std::size_t first_face) {
  const std::size_t last_face = assembly.mesh.face_count();
  std::map<std::uint32_t, std::uint32_t> mirrored;
  for (std::size_t f = first_face; f < last_face; ++f) {
    std::vector<std::uint32_t> corners(assembly.mesh.face(f).begin(), assembly.mesh.face(f).end());
    std::reverse(corners.begin(), corners.end());
    for (std::uint32_t& corner : corners) {
      const auto [entry, is_new] = mirrored.try_emplace(corner, 0);
      if (is_new) {
        const Vec3 p = assembly.mesh.vertices[corner];
        entry->second = add_vertex(assembly, Vec3(-p.x(), p.y(), p.z()));
      }
      corner = entry->second;
    }
    assembly.mesh.add_face(corners);
    assembly.labels.push_back(assembly.labels[f]);
  }
}

std::vector<Vec3> curve(const Vec3& from, const Vec3& towards, const Vec3& to, int points) {
  std::vector<Vec3> path;
  for (int i = 0; i < points; ++i) {
    const double t = static_cast<double>(i) / (points - 1);
    path.push_back((1 - t) * (1 - t) * from + 2 * t * (1 - t) * towards + t * t * to);
  }
  return path;
}

}  // namespace archetype
