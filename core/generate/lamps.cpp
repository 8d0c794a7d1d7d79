// Lamps: on a table, on the floor, with a jointed arm on a desk, hanging from the ceiling.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "core/generate/family.h"

namespace archetype {

namespace {

enum Label { shade, tube, base };
enum Landmark {
  shade_rim_front,
  shade_rim_back,
  shade_rim_left,
  shade_rim_right,
  shade_end_front,
  tube_start,
  tube_end,
  base_centre,
  base_front
};

constexpr double pi = std::numbers::pi;

void mark(Assembly& assembly, Landmark landmark, Label label, const Vec3& position) {
  assembly.landmarks.push_back({static_cast<std::size_t>(landmark), label, position});
}

// The outline (radius, distance along the axis) of a shade from its rim (wide, distance 0) to its end:
// straight for bow = 0, bell-shaped below, a dome above.
Profile shade_outline(double rim, double end, double length, double bow) {
  constexpr int steps = 8;
  Profile outline;
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    outline.emplace_back(rim + (end - rim) * t + bow * (rim + end) * t * (1 - t), length * t);
  }
  return outline;
}

// A thin shell, open at both ends, with the wire cross that carries it at its end.
void add_shade(Assembly& assembly, const ParameterValues& p, const Vec3& rim_centre, const Vec3& axis,
               double spokes_at) {
  const double rim = p["shade_rim"];
  const double end = rim * p["shade_end"];
  const double length = p["shade_length"];
  const double wall = 0.004;
  const Profile outer = shade_outline(rim, end, length, p["shade_bow"]);
  Profile outline = outer;
  for (std::size_t i = outer.size(); i-- > 0;) outline.emplace_back(outer[i].x() - wall, outer[i].y());
  add_turned(assembly, shade, rim_centre, axis, outline, 28, LoftEnds::joined);
  const Vec2& entry =
      outer[static_cast<std::size_t>(std::lround(spokes_at * static_cast<double>(outer.size() - 1)))];
  const Vec3 hub = rim_centre + entry.y() * axis;
  for (int i = 0; i < 3; ++i) {
    const double angle = 2 * pi * (i + 0.25) / 3;
    const Vec3 side = axis.cross(std::abs(axis.x()) < 0.9 ? Vec3::UnitX() : Vec3::UnitZ()).normalized();
    const Vec3 out = std::cos(angle) * side + std::sin(angle) * axis.cross(side);
    add_tube(assembly, shade, hub, hub + (entry.x() - 0.5 * wall) * out, 0.0025, 6);
  }
}

// The points of the rim and of the end that face front, back, left and right once the shade points down.
void mark_shade(Assembly& assembly, const ParameterValues& p, const Vec3& rim_centre, const Vec3& axis,
                const Vec3& front) {
  const double rim = p["shade_rim"];
  const Vec3 left = front.cross(axis).x() > 0 ? front.cross(axis) : Vec3(-front.cross(axis));
  mark(assembly, shade_rim_front, shade, rim_centre + rim * front);
  mark(assembly, shade_rim_back, shade, rim_centre - rim * front);
  mark(assembly, shade_rim_left, shade, rim_centre + rim * left);
  mark(assembly, shade_rim_right, shade, rim_centre - rim * left);
  mark(assembly, shade_end_front, shade,
       rim_centre + p["shade_length"] * axis + rim * p["shade_end"] * front);
}

void add_round_foot(Assembly& assembly, double radius, double height, double neck) {
  add_turned(assembly, base, Vec3::Zero(), Vec3::UnitY(),
             {{0.95 * radius, 0},
              {radius, 0.15 * height},
              {radius, 0.45 * height},
              {0.9 * radius, 0.7 * height},
              {0.45 * radius, 0.92 * height},
              {neck, height}},
             28);
  mark(assembly, base_front, base, Vec3(0, 0.3 * height, radius));
}

Assembly build_table_lamp(const ParameterValues& p) {
  Assembly assembly;
  const double body = p["body_height"];
  const double girth = p["body_radius"];
  const double thick = p["tube_radius"];
  if (p.is("vase")) {
    // A turned vase: foot, belly, neck.
    const double belly = p["body_belly"];
    Profile outline = {{0.62 * girth, 0}, {0.66 * girth, 0.02 * body}};
    constexpr int steps = 14;
    for (int i = 0; i <= steps; ++i) {
      const double t = static_cast<double>(i) / steps;
      const double swell = std::pow(std::sin(pi * std::pow(t, belly)), 1.5);
      outline.emplace_back(girth * (0.5 * (1 - t) + 0.2 * t + 0.55 * swell), body * (0.06 + 0.94 * t));
    }
    add_turned(assembly, base, Vec3::Zero(), Vec3::UnitY(), outline, 26);
    mark(assembly, base_front, base, Vec3(0, 0, 0.62 * girth));
  } else {
    add_round_foot(assembly, girth, 0.035, 1.3 * thick);
  }
  mark(assembly, base_centre, base, Vec3::Zero());
  const double start = p.is("vase") ? body : 0.035;
  const double length = p["shade_length"];
  const double rim_height = body + p["gap"];
  const double end = rim_height + 0.875 * length;
  add_turned(assembly, tube, Vec3::Zero(), Vec3::UnitY(),
             {{thick, start - 0.006},
              {thick, rim_height + 0.25 * length},
              {1.6 * thick, rim_height + 0.26 * length},
              {1.6 * thick, rim_height + 0.45 * length},
              {0.6 * thick, rim_height + 0.46 * length},
              {0.6 * thick, end + 0.01}},
             14);
  mark(assembly, tube_start, tube, Vec3(0, start, thick));
  mark(assembly, tube_end, tube, Vec3(0, end + 0.01, 0));
  const Vec3 rim_centre(0, rim_height, 0);
  add_shade(assembly, p, rim_centre, Vec3::UnitY(), 0.875);
  mark_shade(assembly, p, rim_centre, Vec3::UnitY(), Vec3::UnitZ());
  return assembly;
}

Assembly build_floor_lamp(const ParameterValues& p) {
  Assembly assembly;
  const double height = p["height"];
  const double thick = p["tube_radius"];
  const double length = p["shade_length"];
  const double rim_height = height - length;
  double start = 0.03;
  if (p.is("tripod")) {
    start = 0.42 * height;
    for (int i = 0; i < 3; ++i) {
      const double angle = 2 * pi * i / 3;
      const Vec3 out(std::sin(angle), 0, std::cos(angle));
      add_leg(assembly, base, Vec3(0, start + 0.02, 0) + 0.6 * thick * out,
              0.55 * p["foot_radius"] * out + 0.55 * out * 0.1 * height,
              ellipse(0.9 * thick, 0.9 * thick, 10), 0.7);
      if (i == 0) mark(assembly, base_front, base, 0.55 * p["foot_radius"] * out + 0.055 * height * out);
    }
    add_turned(assembly, base, Vec3(0, start, 0), Vec3::UnitY(),
               {{1.7 * thick, -0.02}, {2 * thick, 0}, {1.7 * thick, 0.03}}, 14);
    mark(assembly, base_centre, base, Vec3(0, start - 0.02, 0));
  } else {
    add_round_foot(assembly, p["foot_radius"], 0.032, 1.5 * thick);
    mark(assembly, base_centre, base, Vec3::Zero());
  }
  const double end = rim_height + 0.5 * length;
  add_turned(assembly, tube, Vec3::Zero(), Vec3::UnitY(),
             {{thick, start - 0.006},
              {thick, 0.5 * (start + end)},
              {0.8 * thick, 0.5 * (start + end)},
              {0.8 * thick, end - 0.06},
              {1.5 * thick, end - 0.05},
              {1.5 * thick, end + 0.012}},
             14);
  mark(assembly, tube_start, tube, Vec3(0, start, thick));
  mark(assembly, tube_end, tube, Vec3(0, end + 0.012, 0));
  const bool uplight = p.is("uplight");
  // An uplight carries its shade the other way round: the wide rim on top.
  const Vec3 rim_centre(0, uplight ? height : rim_height, 0);
  const Vec3 axis = uplight ? Vec3(-Vec3::UnitY()) : Vec3(Vec3::UnitY());
  add_shade(assembly, p, rim_centre, axis, 0.5);
  mark_shade(assembly, p, rim_centre, axis, Vec3::UnitZ());
  return assembly;
}

Assembly build_desk_lamp(const ParameterValues& p) {
  Assembly assembly;
  const double thick = p["tube_radius"];
  add_round_foot(assembly, p["foot_radius"], 0.035, 2.2 * thick);
  mark(assembly, base_centre, base, Vec3::Zero());
  const double lower = p["lower_angle"] * pi / 180;
  const double upper = p["upper_angle"] * pi / 180;
  const Vec3 foot(0, 0.033, 0);
  const Vec3 elbow = foot + p["lower_arm"] * Vec3(0, std::cos(lower), -std::sin(lower));
  const Vec3 head = elbow + p["upper_arm"] * Vec3(0, std::sin(upper), std::cos(upper));
  const auto joint = [&](const Vec3& centre) {
    add_tube(assembly, tube, centre - 2.2 * thick * Vec3::UnitX(), centre + 2.2 * thick * Vec3::UnitX(),
             1.9 * thick, 14);
  };
  if (p.is("double_bars")) {
    for (const double side : {-1.3, 1.3}) {
      add_tube(assembly, tube, foot + side * thick * Vec3::UnitX(), elbow + side * thick * Vec3::UnitX(),
               0.6 * thick, 10);
      add_tube(assembly, tube, elbow + side * thick * Vec3::UnitX(), head + side * thick * Vec3::UnitX(),
               0.6 * thick, 10);
    }
  } else {
    add_tube(assembly, tube, foot, elbow, thick, 12);
    add_tube(assembly, tube, elbow, head, thick, 12);
  }
  joint(elbow);
  joint(head);
  mark(assembly, tube_start, tube, foot);
  mark(assembly, tube_end, tube, head + 1.9 * thick * Vec3::UnitY());
  // The shade looks down and forward; its axis runs from the rim back to the joint.
  const double tilt = p["shade_tilt"] * pi / 180;
  const Vec3 axis(0, std::cos(tilt), -std::sin(tilt));
  const Vec3 front(0, std::sin(tilt), std::cos(tilt));
  const double length = p["shade_length"];
  const double end = p["shade_rim"] * p["shade_end"];
  const Vec3 rim_centre = head - (length + 0.02) * axis;
  add_shade(assembly, p, rim_centre, axis, 0.875);
  add_turned(assembly, shade, rim_centre, axis,
             {{end - 0.002, 0.97 * length},
              {end, length},
              {0.75 * end, length + 0.012},
              {1.2 * thick, length + 0.022}},
             28);
  mark_shade(assembly, p, rim_centre, axis, front);
  return assembly;
}

Assembly build_pendant(const ParameterValues& p) {
  Assembly assembly;
  const double length = p["shade_length"];
  const double end = p["shade_rim"] * p["shade_end"];
  const double cord = length + p["cord_length"];
  const double canopy = p["canopy_radius"];
  const double thick = p["tube_radius"];
  add_shade(assembly, p, Vec3::Zero(), Vec3::UnitY(), 0.875);
  add_turned(assembly, shade, Vec3::Zero(), Vec3::UnitY(),
             {{end - 0.002, 0.985 * length},
              {end, length},
              {0.8 * end, length + 0.012},
              {2.5 * thick, length + 0.02},
              {2 * thick, length + 0.06}},
             28);
  mark_shade(assembly, p, Vec3::Zero(), Vec3::UnitY(), Vec3::UnitZ());
  add_tube(assembly, tube, {{0, length + 0.04, 0}, {0, 0.5 * (length + cord), 0}, {0, cord + 0.01, 0}},
           {thick, thick, thick}, 10);
  mark(assembly, tube_start, tube, Vec3(0, cord, thick));
  mark(assembly, tube_end, tube, Vec3(0, length + 0.06, thick));
  add_turned(assembly, base, Vec3::Zero(), Vec3::UnitY(),
             {{2 * thick, cord - 0.006},
              {0.55 * canopy, cord},
              {0.93 * canopy, cord + 0.016},
              {canopy, cord + 0.03},
              {canopy, cord + 0.042}},
             26);
  mark(assembly, base_centre, base, Vec3(0, cord + 0.042, 0));
  mark(assembly, base_front, base, Vec3(0, cord + 0.036, canopy));
  return assembly;
}

std::vector<Parameter> with_shade(Distribution rim, Distribution end, Distribution length, Distribution bow,
                                  std::vector<Parameter> rest) {
  std::vector<Parameter> all = {{"shade_rim", rim, "radius of the wide rim, metres"},
                                {"shade_end", end, "radius of the other end over that of the rim"},
                                {"shade_length", length, "metres"},
                                {"shade_bow", bow, "below 0 bell-shaped, above a dome"}};
  all.insert(all.end(), rest.begin(), rest.end());
  return all;
}

}  // namespace

Family lamps() {
  return {.name = "lamps",
          .shape = "lamp",
          .labels = {{"shade", false}, {"tube"}, {"base"}},
          .landmarks = {"shade_rim_front", "shade_rim_back", "shade_rim_left", "shade_rim_right",
                        "shade_end_front", "tube_start", "tube_end", "base_centre", "base_front"},
          .styles = {
              {"table", 3,
               with_shade(uniform(0.13, 0.2), uniform(0.5, 1), uniform(0.15, 0.24), uniform(-0.12, 0.12),
                          {{"vase", chance(0.6), "the base is a vase, else a round foot"},
                           {"body_height", normal(0.28, 0.04), "of the vase, metres"},
                           {"body_radius", normal(0.09, 0.012), "of the vase or foot, metres"},
                           {"body_belly", uniform(0.6, 1.5), "below 1 the vase is widest low"},
                           {"tube_radius", uniform(0.006, 0.012), "metres"},
                           {"gap", uniform(0.02, 0.07), "between vase and shade, metres"}}),
               build_table_lamp},
              {"floor", 3,
               with_shade(uniform(0.16, 0.26), uniform(0.45, 1), uniform(0.2, 0.32), uniform(-0.1, 0.15),
                          {{"height", normal(1.58, 0.1), "metres"},
                           {"tube_radius", uniform(0.01, 0.018), "metres"},
                           {"foot_radius", normal(0.16, 0.015), "metres"},
                           {"tripod", chance(0.35), "stands on three legs, else on a round foot"},
                           {"uplight", chance(0.25), "the shade opens upwards"}}),
               build_floor_lamp},
              {"desk", 2,
               with_shade(uniform(0.07, 0.1), uniform(0.3, 0.5), uniform(0.1, 0.16), uniform(0, 0.3),
                          {{"tube_radius", uniform(0.006, 0.01), "metres"},
                           {"foot_radius", normal(0.1, 0.01), "metres"},
                           {"lower_arm", normal(0.33, 0.03), "metres"},
                           {"upper_arm", normal(0.3, 0.03), "metres"},
                           {"lower_angle", uniform(5, 40), "backwards from upright, degrees"},
                           {"upper_angle", uniform(0, 45), "upwards from level, degrees"},
                           {"shade_tilt", uniform(0, 40), "of the shade forwards, degrees"},
                           {"double_bars", chance(0.5), "two thin bars side by side, else one"}}),
               build_desk_lamp},
              {"pendant", 2,
               with_shade(uniform(0.16, 0.28), uniform(0.2, 0.6), uniform(0.14, 0.24), uniform(-0.05, 0.35),
                          {{"tube_radius", uniform(0.003, 0.006), "of the cord, metres"},
                           {"cord_length", normal(0.6, 0.12), "metres"},
                           {"canopy_radius", uniform(0.045, 0.07), "at the ceiling, metres"}}),
               build_pendant},
          }};
}

}  // namespace archetype
