// The parts of chairs, each placed by the parts before it.
#include "core/generate/chair_parts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace archetype::chair_parts {

namespace {

// A pair of landmarks, left at +x.
void mark_pair(Chair& chair, Landmark left, Label label, const Vec3& position) {
  chair.assembly.landmarks.push_back({static_cast<std::size_t>(left), label, position});
  chair.assembly.landmarks.push_back(
      {static_cast<std::size_t>(left) + 1, label, Vec3(-position.x(), position.y(), position.z())});
}

// The point of the seat's outline above which a leg stands: +1 in front, -1 behind, at the left.
Vec3 seat_corner(const Chair& chair, double end) {
  const double narrow = 1 - chair.p["seat_taper"] * 0.5 * (1 - end * chair.corner);
  return {chair.half_width * chair.corner * narrow, chair.top, end * chair.half_depth * chair.corner};
}

// Half the width of the back, which stands between the rear corners of the seat.
double half_back_width(const Chair& chair) {
  return seat_corner(chair, -1).x() * chair.p["back_width"];
}

}  // namespace

void add_seat(Chair& chair) {
  const ParameterValues& p = chair.p;
  const double thickness = p["seat_thickness"];
  const double crown = p["seat_crown"];
  const double taper = p["seat_taper"];
  const double roundness = p["seat_roundness"];
  chair.corner = std::sqrt(1 - 0.5 * roundness);
  chair.half_width = 0.5 * p["seat_width"];
  chair.half_depth = 0.5 * p["seat_depth"];
  chair.top = p["seat_height"];
  chair.underside = chair.top - thickness;
  const Vec3 half(chair.half_width, 0.5 * thickness, chair.half_depth);
  const double height = chair.top - 0.5 * thickness;
  const auto shape = [=](const Vec3& local) {
    const Vec2 u(local.x() / half.x(), local.z() / half.z());
    // Roundness 1 takes the square to an ellipse.
    const double x = local.x() * std::sqrt(1 - 0.5 * roundness * u.y() * u.y());
    const double z = local.z() * std::sqrt(1 - 0.5 * roundness * u.x() * u.x());
    const double narrow = 1 - taper * 0.5 * (1 - z / half.z());
    const double bulge = local.y() > 0 ? crown * (1 - u.x() * u.x()) * (1 - u.y() * u.y()) : 0;
    return Vec3(x * narrow, height + local.y() + bulge, z);
  };
  const int across = std::max(4, static_cast<int>(p["seat_width"] / 0.1));
  add_block(chair.assembly, seat, half, p["seat_rounding"] * thickness, {across, 1, 5}, shape);
  mark_pair(chair, seat_front_left, seat, seat_corner(chair, 1));
  mark_pair(chair, seat_back_left, seat, seat_corner(chair, -1));
}

void add_legs(Chair& chair) {
  const ParameterValues& p = chair.p;
  Assembly& assembly = chair.assembly;
  const double inset = 0.6 * p["leg_thickness"];
  const double splay = p["leg_splay"];
  const double top = chair.underside + 0.004;
  const Vec3 front_corner = seat_corner(chair, 1);
  const Vec3 rear_corner = seat_corner(chair, -1);
  const Vec3 front(front_corner.x() - inset, top, front_corner.z() - inset);
  const Vec3 rear(rear_corner.x() - inset, top, rear_corner.z() + inset);
  const Vec3 front_foot(front.x() + splay, 0, front.z() + splay);
  const Vec3 rear_foot(rear.x() + splay, 0, rear.z() - splay);
  const double half = 0.5 * p["leg_thickness"];
  const Profile profile =
      p.is("leg_round") ? ellipse(half, half, 12) : rounded_rectangle(half, half, 0.3 * half, 2);

  const std::size_t first = assembly.mesh.face_count();
  add_leg(assembly, leg, front, front_foot, profile, p["leg_taper"]);
  add_leg(assembly, leg, rear, rear_foot, profile, p["leg_taper"]);
  const double radius = 0.3 * p["leg_thickness"];
  const auto between = [](const Vec3& low, const Vec3& high, double t) {
    return Vec3(low + t * (high - low));
  };
  const double level = p["stretcher_level"];
  if (p.is("stretchers")) {
    add_tube(assembly, leg, between(front_foot, front, level), between(rear_foot, rear, level), radius, 8);
  }
  add_mirrored(assembly, first);
  if (p.is("stretchers")) {
    Vec3 left = 0.5 * (between(front_foot, front, level) + between(rear_foot, rear, level));
    if (p.is("stretcher_front")) left = between(front_foot, front, level + 0.12);
    add_tube(assembly, leg, Vec3(-left.x(), left.y(), left.z()), left, radius, 8);
  }
  if (chair.half_width > 0.7) {
    add_leg(assembly, leg, Vec3(0, top, front.z()), Vec3(0, 0, front_foot.z()), profile, p["leg_taper"]);
    add_leg(assembly, leg, Vec3(0, top, rear.z()), Vec3(0, 0, rear_foot.z()), profile, p["leg_taper"]);
  }
  mark_pair(chair, foot_front_left, leg, front_foot);
  mark_pair(chair, foot_back_left, leg, rear_foot);
}

namespace {

// From back coordinates (x across, y up from the seat, z forward) to the chair: tilted, and bent about a
// vertical axis so that it embraces the sitter.
Placement back_placement(const Chair& chair) {
  const double tilt = chair.p["back_tilt"] * std::numbers::pi / 180;
  const double curve_depth = chair.p["back_curve"];
  const double half_width = half_back_width(chair);
  const double z = seat_corner(chair, -1).z() + 0.5 * chair.p["back_thickness"];
  const double y = chair.top - 0.3 * chair.p["seat_thickness"];
  return [=](const Vec3& local) {
    const double u = local.x() / half_width;
    const double forward = local.z() - curve_depth * (1 - u * u);
    return Vec3(local.x(), y + local.y() * std::cos(tilt) + forward * std::sin(tilt),
                z + curve_depth - local.y() * std::sin(tilt) + forward * std::cos(tilt));
  };
}

// A board of the back between two corners of its own plane.
void add_back_board(Chair& chair, const Vec2& low, const Vec2& high, double thickness, double rounding) {
  const Placement placement = back_placement(chair);
  const Vec3 centre(0.5 * (low.x() + high.x()), 0.5 * (low.y() + high.y()), 0);
  const Vec3 half(0.5 * (high.x() - low.x()), 0.5 * (high.y() - low.y()), 0.5 * thickness);
  const auto cells = [](double extent) {
    return std::clamp(static_cast<int>(std::ceil(extent / 0.08)), 1, 24);
  };
  add_block(chair.assembly, back, half, rounding * thickness, {cells(2 * half.x()), cells(2 * half.y()), 1},
            [=](const Vec3& local) { return placement(centre + local); });
}

}  // namespace

void add_back(Chair& chair) {
  const ParameterValues& p = chair.p;
  const double height = p["back_height"];
  const double half_width = half_back_width(chair);
  const double thickness = p["back_thickness"];
  const int kind = static_cast<int>(p["back_kind"]);
  if (kind == 0) {
    const double gap = p["back_gap"];
    add_back_board(chair, {-half_width, gap * height}, {half_width, height}, thickness, 0.45);
    const double bar = 0.18 * half_width;
    if (gap > 0.05) {
      add_back_board(chair, {-0.75 * half_width, 0}, {-0.75 * half_width + bar, gap * height + 0.01},
                     0.6 * thickness, 0.3);
      add_back_board(chair, {0.75 * half_width - bar, 0}, {0.75 * half_width, gap * height + 0.01},
                     0.6 * thickness, 0.3);
    }
  } else {
    const double post = std::max(0.022, 0.8 * thickness);
    const double rail = 0.11 * height;
    add_back_board(chair, {-half_width, 0}, {-half_width + post, height}, thickness, 0.3);
    add_back_board(chair, {half_width - post, 0}, {half_width, height}, thickness, 0.3);
    const double inner = half_width - 0.7 * post;
    add_back_board(chair, {-inner, height - rail - 0.01}, {inner, height - 0.01}, 0.7 * thickness, 0.3);
    const int slats = static_cast<int>(p["back_slats"]);
    if (kind == 1) {
      add_back_board(chair, {-inner, 0.18 * height}, {inner, 0.18 * height + 0.7 * rail}, 0.7 * thickness,
                     0.3);
      const int count = std::max(2, static_cast<int>(slats * half_width / 0.22));
      const double pitch = 2 * inner / (count + 1);
      for (int i = 1; i <= count; ++i) {
        const double x = -inner + i * pitch;
        add_back_board(chair, {x - 0.2 * pitch, 0.18 * height + 0.3 * rail},
                       {x + 0.2 * pitch, height - 0.5 * rail}, 0.4 * thickness, 0.3);
      }
    } else {
      for (int i = 0; i < slats - 1; ++i) {
        const double y = height * (0.25 + 0.55 * i / (slats - 1));
        add_back_board(chair, {-inner, y}, {inner, y + 0.6 * rail}, 0.6 * thickness, 0.3);
      }
    }
  }
  mark_pair(chair, back_top_left, back, back_placement(chair)(Vec3(half_width, height, 0.5 * thickness)));
}

void add_arms(Chair& chair) {
  const ParameterValues& p = chair.p;
  if (!p.is("arms")) return;
  const double rest = chair.top + p["arm_height"];
  const double thickness = p["arm_thickness"];
  const double width = p["arm_width"];
  const double front_z = chair.half_depth * (1 - p["arm_setback"]);
  // From over the seat's edge in front into the side of the back.
  const Vec3 behind = back_placement(chair)(Vec3(half_back_width(chair), p["arm_height"], 0));
  const Vec3 rear(behind.x() + 0.15 * width, rest - 0.5 * thickness, behind.z());
  const Vec3 front(chair.half_width + 0.2 * width, rest - 0.5 * thickness, front_z);
  const std::size_t first = chair.assembly.mesh.face_count();
  add_block(chair.assembly, arm, Vec3(0.5 * width, 0.5 * thickness, 0.5 * (front - rear).norm()),
            0.4 * thickness, {1, 1, 5}, along(rear, front, Vec3::UnitY()));
  if (p.is("arm_panel")) {
    const double low = chair.underside + 0.3 * p["seat_thickness"];
    const double high = rest - thickness;
    const Vec3 middle(0, 0.5 * (low + high), 0);
    const Vec3 behind_seat(rear.x(), 0, seat_corner(chair, -1).z());
    const Placement placement = along(behind_seat, Vec3(front.x(), 0, front_z), Vec3::UnitY());
    const double length = (Vec3(front.x(), 0, front_z) - behind_seat).norm();
    add_block(chair.assembly, arm, Vec3(0.36 * width, 0.5 * (high - low) + 0.004, 0.48 * length), 0.1 * width,
              {1, 3, 5}, [=](const Vec3& local) { return placement(local + middle); });
  } else {
    const double radius = 0.3 * std::min(thickness, width);
    const Vec3 foot(seat_corner(chair, 1).x() - 0.3 * width, chair.top - 0.5 * p["seat_thickness"],
                    0.7 * std::min(front_z, seat_corner(chair, 1).z()));
    const Vec3 top = rear + 0.92 * (front - rear) - Vec3(0, 0.1 * thickness, 0);
    add_tube(chair.assembly, arm,
             curve(foot, Vec3(top.x(), 0.6 * chair.top + 0.4 * rest, 0.5 * (foot.z() + top.z())), top, 6),
             std::vector<double>(6, radius), 8);
  }
  add_mirrored(chair.assembly, first);
  mark_pair(chair, arm_front_left, arm, Vec3(front.x(), rest, front_z));
}

void add_star_base(Chair& chair) {
  const ParameterValues& p = chair.p;
  Assembly& assembly = chair.assembly;
  const double radius = p["star_radius"];
  const double castor = p["castor_radius"];
  const double hub = 2 * castor + 0.045;
  const double thick = p["stem_radius"];
  const double sleeve = hub + 0.45 * (chair.underside - hub);
  add_turned(assembly, stem, Vec3::Zero(), Vec3::UnitY(),
             {{thick, hub},
              {thick, sleeve},
              {0.6 * thick, sleeve},
              {0.6 * thick, chair.underside - 0.02},
              {3 * thick, chair.underside - 0.02},
              {3 * thick, chair.underside + 0.003}},
             14);
  add_turned(assembly, base, Vec3::Zero(), Vec3::UnitY(),
             {{1.3 * thick, hub - 0.045},
              {1.7 * thick, hub - 0.03},
              {1.6 * thick, hub + 0.01},
              {1.1 * thick, hub + 0.04}},
             14);
  const int arms = static_cast<int>(p["star_arms"]);
  for (int i = 0; i < arms; ++i) {
    const double angle = 2 * std::numbers::pi * i / arms;
    const Vec3 out(std::sin(angle), 0, std::cos(angle));
    const Vec3 side = Vec3::UnitY().cross(out);
    const Vec3 tip = radius * out + (2 * castor + 0.012) * Vec3::UnitY();
    std::vector<Ring> rings;
    for (int k = 0; k <= 5; ++k) {
      const double t = k / 5.0;
      const Vec3 centre =
          (1 - t) * (hub * Vec3::UnitY() + 0.5 * thick * out) + t * tip + 0.02 * t * (1 - t) * Vec3::UnitY();
      rings.push_back(place(rounded_rectangle(0.025 - 0.008 * t, 0.018 - 0.008 * t, 0.006, 2), centre, side,
                            Vec3::UnitY()));
    }
    add_loft(assembly, base, rings);
    const Vec3 axle = (radius - 0.3 * castor) * out + castor * Vec3::UnitY();
    add_tube(assembly, base, tip - 0.3 * castor * out, axle + 0.4 * castor * Vec3::UnitY(), 0.3 * castor, 8);
    for (const double s : {-1.0, 1.0}) {
      const Vec3 inner = axle + s * 0.12 * castor * side;
      const Vec3 outer = axle + s * 0.75 * castor * side;
      add_tube(assembly, base, {inner, outer}, {castor, 0.95 * castor}, 14);
    }
  }
  assembly.landmarks.push_back({base_centre, base, Vec3(0, hub - 0.045, 0)});
}

void add_pedestal(Chair& chair) {
  const ParameterValues& p = chair.p;
  const double thick = 0.8 * p["leg_thickness"];
  const double plate = 0.85 * chair.half_width + 0.03;
  add_turned(chair.assembly, stem, Vec3::Zero(), Vec3::UnitY(),
             {{thick, 0.015},
              {thick, 0.5 * chair.top},
              {0.75 * thick, 0.5 * chair.top},
              {0.75 * thick, chair.underside - 0.02},
              {3.2 * thick, chair.underside - 0.005},
              {3.2 * thick, chair.underside + 0.003}},
             16);
  add_turned(
      chair.assembly, base, Vec3::Zero(), Vec3::UnitY(),
      {{0.94 * plate, 0}, {plate, 0.006}, {0.97 * plate, 0.014}, {0.5 * plate, 0.024}, {1.2 * thick, 0.045}},
      24);
  chair.assembly.landmarks.push_back({base_centre, base, Vec3::Zero()});

  // The footrest reaches forward.
  const double y = p["footrest_level"] * chair.underside;
  const double radius = 0.75 * chair.half_width;
  const double bar = 0.011;
  const Vec3 forward(0, 0, 0.35 * radius);
  add_turned(chair.assembly, stem, Vec3(0, y, 0) + forward, Vec3::UnitY(),
             {{radius + bar, 0}, {radius, bar}, {radius - bar, 0}, {radius, -bar}}, 20, LoftEnds::joined);
  add_tube(chair.assembly, stem, Vec3(0, y, 0), Vec3(0, y, radius) + forward, 0.8 * bar, 8);
}

}  // namespace archetype::chair_parts
