// Planes: airliners and fighters. The nose points to +z.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "core/generate/family.h"

namespace archetype {

namespace {

enum Label { body, wing, stabiliser, rudder, engine };
enum Landmark {
  nose,
  tail,
  wing_tip_left,
  wing_tip_right,
  wing_root_front_left,
  wing_root_front_right,
  stabiliser_tip_left,
  stabiliser_tip_right,
  rudder_top,
  engine_front_left,
  engine_front_right
};

constexpr double pi = std::numbers::pi;

void mark(Assembly& assembly, Landmark landmark, Label label, const Vec3& position) {
  assembly.landmarks.push_back({static_cast<std::size_t>(landmark), label, position});
}

void mark_pair(Assembly& assembly, Landmark left, Label label, const Vec3& position) {
  assembly.landmarks.push_back({static_cast<std::size_t>(left), label, position});
  assembly.landmarks.push_back(
      {static_cast<std::size_t>(left) + 1, label, Vec3(-position.x(), position.y(), position.z())});
}

// One station of a lifting surface: the middle of its chord, the chord's length, the thickness over it.
struct Station {
  Vec3 middle;
  double chord = 0;
  double thickness = 0.1;
};

// A lifting surface through the stations; `up` is its upper side. Runs along front × -up, i.e. +x for up =
// +y.
void add_surface(Assembly& assembly, int label, const std::vector<Station>& stations, const Vec3& up,
                 int bands) {
  std::vector<Ring> rings;
  const auto add = [&](const Station& station) {
    rings.push_back(
        place(wing_section(station.chord, station.thickness, 8), station.middle, Vec3::UnitZ(), -up));
  };
  for (std::size_t i = 0; i + 1 < stations.size(); ++i) {
    for (int k = 0; k < bands; ++k) {
      const double t = static_cast<double>(k) / bands;
      const Station& a = stations[i];
      const Station& b = stations[i + 1];
      add({(1 - t) * a.middle + t * b.middle, (1 - t) * a.chord + t * b.chord,
           (1 - t) * a.thickness + t * b.thickness});
    }
  }
  add(stations.back());
  Station end = stations.back();  // a rounded tip
  end.middle += 0.06 * end.chord * (end.middle - stations[stations.size() - 2].middle).normalized();
  end.chord *= 0.8;
  end.thickness *= 0.4;
  add(end);
  add_loft(assembly, label, rings);
}

// A body along z from the tail (t = 0) to the nose (t = 1): the section at t has half width and height
// `size(t)` about the axis raised by `rise(t)`.
void add_fuselage(Assembly& assembly, double length, double exponent, int sides,
                  const std::vector<double>& stations, const std::function<Vec2(double)>& size,
                  const std::function<double(double)>& rise) {
  std::vector<Ring> rings;
  for (const double t : stations) {
    const Vec2 half = size(t);
    rings.push_back(place(superellipse(half.x(), half.y(), exponent, sides),
                          Vec3(0, rise(t), length * (t - 0.5)), Vec3::UnitX(), Vec3::UnitY()));
  }
  add_loft(assembly, body, rings);
}

// Denser towards both ends, where the body curves.
std::vector<double> fuselage_stations(int count) {
  std::vector<double> stations;
  for (int i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / (count - 1);
    stations.push_back(0.2 * t + 0.4 * (1 - std::cos(pi * t)));
  }
  stations.insert(stations.end() - 1, 0.25 * *(stations.end() - 2) + 0.75);
  return stations;
}

// A nacelle that can be looked into, with the cone of the exhaust behind.
void add_nacelle(Assembly& assembly, const Vec3& front, double length, double radius, int sides) {
  const double l = length;
  const double r = radius;
  add_turned(assembly, engine, front - l * Vec3::UnitZ(), Vec3::UnitZ(),
             {{0.06 * r, -0.12 * l},
              {0.3 * r, 0.02 * l},
              {0.32 * r, 0.06 * l},
              {0.62 * r, 0.02 * l},
              {0.7 * r, 0.05 * l},
              {0.9 * r, 0.3 * l},
              {r, 0.6 * l},
              {r, 0.8 * l},
              {0.94 * r, 0.95 * l},
              {0.86 * r, l},
              {0.78 * r, 0.96 * l},
              {0.76 * r, 0.8 * l},
              {0.25 * r, 0.8 * l},
              {0.05 * r, 0.9 * l}},
             sides);
}

Assembly build_airliner(const ParameterValues& p) {
  Assembly assembly;
  const double length = p["length"];
  const double r = 0.5 * p["girth"] * length;
  const auto size = [=](double t) {
    const double nose_start = 0.87;
    double s = 1;
    if (t < 0.34) s = 0.1 + 0.9 * std::pow(std::sin(0.5 * pi * t / 0.34), 0.9);
    if (t > nose_start) s = std::sqrt(std::max(0.0, 1 - std::pow((t - nose_start) / (1 - nose_start), 2.2)));
    return Vec2(std::max(s, 0.03) * r, std::max(s, 0.03) * r * 1.05);
  };
  const auto rise = [=](double t) {
    if (t < 0.34) return 0.72 * r * std::pow(1 - t / 0.34, 1.4);
    return t > 0.87 ? -0.22 * r * std::pow((t - 0.87) / 0.13, 2) : 0.0;
  };
  add_fuselage(assembly, length, 2, 22, fuselage_stations(28), size, rise);
  mark(assembly, nose, body, Vec3(0, rise(1), 0.5 * length));
  mark(assembly, tail, body, Vec3(0, rise(0), -0.5 * length));

  const double half_span = 0.5 * p["span"] * length;
  const double sweep = std::tan(p["sweep"] * pi / 180);
  const double dihedral = std::tan(p["dihedral"] * pi / 180);
  const double root_chord = p["root_chord"] * length;
  const double tip_chord = p["tip_chord"] * root_chord;
  const double wing_z = p["wing_place"] * length;
  const double wing_y = -0.55 * r;
  const auto station = [&](double share) {
    // The trailing edge runs straight across to the kink, so the chord falls faster there.
    const double kink = 0.33;
    const double kink_chord = 0.58 * root_chord + 0.05 * tip_chord;
    const double chord = share < kink ? root_chord + (kink_chord - root_chord) * share / kink
                                      : kink_chord + (tip_chord - kink_chord) * (share - kink) / (1 - kink);
    const double x = share * half_span;
    const double leading = wing_z + 0.5 * root_chord - x * sweep;
    return Station{Vec3(x, wing_y + x * dihedral, leading - 0.5 * chord), chord, 0.13 - 0.04 * share};
  };
  const std::size_t first = assembly.mesh.face_count();
  std::vector<Station> stations = {station(0.02), station(0.33), station(1)};
  const Station tip = stations.back();
  if (p.is("winglets")) {
    Station upright = tip;
    upright.middle += Vec3(0.03 * half_span, 0.1 * half_span, -0.045 * half_span * 2);
    upright.chord *= 0.5;
    stations.push_back(upright);
  }
  add_surface(assembly, wing, stations, Vec3::UnitY(), 4);
  const double engine_radius = p["engine_radius"] * r;
  const double engine_length = 3.1 * engine_radius;
  const int pairs = static_cast<int>(p["engine_pairs"]);
  const bool at_tail = p.is("engines_at_tail");
  Vec3 first_engine = Vec3::Zero();
  for (int i = 0; i < (at_tail ? 1 : pairs); ++i) {
    Vec3 front;
    if (at_tail) {
      front = Vec3(1.02 * r + 0.95 * engine_radius, 0.45 * r, -0.5 * length + 0.36 * length);
      add_block(assembly, engine,
                Vec3(0.5 * engine_radius + 0.1 * r, 0.09 * engine_radius, 0.5 * engine_length),
                0.04 * engine_radius, {2, 1, 3},
                at(front - Vec3(0.9 * engine_radius + 0.05 * r, 0, 0.6 * engine_length)));
    } else {
      const Station hang = station(pairs == 1 ? 0.34 : 0.31 + 0.3 * i);
      front = hang.middle + Vec3(0, -1.35 * engine_radius, 0.5 * hang.chord + 0.52 * engine_length);
      const Vec3 from = front + Vec3(0, 0.85 * engine_radius, -0.35 * engine_length);
      const Vec3 to = hang.middle + Vec3(0, -0.3 * engine_radius, 0.1 * hang.chord);
      const double slope = (to.y() - from.y()) / (from.z() - to.z());
      add_block(assembly, engine, Vec3(0.09 * engine_radius, 0.26 * engine_radius, 0.5 * (from.z() - to.z())),
                0.05 * engine_radius, {1, 1, 3},
                [=](const Vec3& q) { return Vec3(0.5 * (from + to) + q - Vec3(0, slope * q.z(), 0)); });
    }
    if (i == 0) first_engine = front;
    add_nacelle(assembly, front, engine_length, engine_radius, 18);
  }

  const double fin_height = p["fin_height"] * length;
  const double fin_chord = 0.75 * root_chord;
  const double tail_z = -0.5 * length;
  const bool t_tail = p.is("t_tail");
  const double tail_y = t_tail ? 0.9 * r + fin_height : 0.5 * r;
  const double tail_span = 0.5 * p["stabiliser_span"] * 2 * half_span;
  const double tail_chord = 0.5 * root_chord;
  const double fin_lean = 0.75 * fin_height;
  const double tail_middle =
      t_tail ? tail_z + 0.55 * fin_chord + 0.05 * length - fin_lean : tail_z + 0.75 * tail_chord;
  const std::vector<Station> tailplane = {
      {Vec3(0.02 * r, tail_y, tail_middle), tail_chord, 0.1},
      {Vec3(tail_span, tail_y + 0.08 * tail_span, tail_middle - 0.62 * tail_span), 0.42 * tail_chord, 0.09}};
  add_surface(assembly, stabiliser, tailplane, Vec3::UnitY(), 5);
  add_mirrored(assembly, first);
  mark_pair(assembly, wing_tip_left, wing, tip.middle);
  mark_pair(assembly, wing_root_front_left, wing, station(0.1).middle + Vec3(0, 0, 0.5 * station(0.1).chord));
  mark_pair(assembly, stabiliser_tip_left, stabiliser, tailplane.back().middle);
  mark_pair(assembly, engine_front_left, engine, first_engine);

  const Station fin_root{Vec3(0, 0.55 * r, tail_z + 0.55 * fin_chord + 0.05 * length), fin_chord, 0.1};
  const Station fin_end{Vec3(0, 0.9 * r + fin_height, fin_root.middle.z() - fin_lean), 0.45 * fin_chord,
                        0.09};
  // A fin is a wing whose upper side faces right: it runs along z × -up = up.
  add_surface(assembly, rudder, {fin_root, fin_end}, -Vec3::UnitX(), 6);
  mark(assembly, rudder_top, rudder, fin_end.middle);
  return assembly;
}

Assembly build_fighter(const ParameterValues& p) {
  Assembly assembly;
  const double length = p["length"];
  const double r = 0.5 * p["girth"] * length;
  const double flat = p["flatness"];
  const auto size = [=](double t) {
    double s = 0.82 + 0.18 * std::sin(pi * std::min(1.0, t / 0.6));
    if (t > 0.5) s *= 1 - std::pow((t - 0.5) / 0.5, 1.7);
    s = std::max(s, 0.015);
    const double broad = 1 + flat * std::clamp((0.72 - t) / 0.2, 0.0, 1.0);
    return Vec2(s * r * broad, s * r);
  };
  const auto rise = [=](double t) { return t > 0.6 ? -0.25 * r * (t - 0.6) / 0.4 : 0.0; };
  add_fuselage(assembly, length, 2.6, 20, fuselage_stations(26), size, rise);
  mark(assembly, nose, body, Vec3(0, rise(1), 0.5 * length));
  mark(assembly, tail, body, Vec3(0, 0, -0.5 * length));

  // The canopy: half sunk into the back of the nose.
  const double canopy = 0.085 * length;
  std::vector<Ring> bubble;
  for (int i = 0; i <= 10; ++i) {
    const double t = i / 10.0;
    const double s = std::max(0.05, std::pow(std::sin(pi * std::pow(t, 1.25)), 0.7));
    bubble.push_back(place(ellipse(0.44 * r * s, 0.82 * r * s, 14),
                           Vec3(0, 0.52 * r - 0.12 * r * t, length * 0.15 + canopy * (2.2 * t - 1)),
                           Vec3::UnitX(), Vec3::UnitY()));
  }
  add_loft(assembly, body, bubble);

  const double half_span = 0.5 * p["span"] * length;
  const double root_chord = p["root_chord"] * length;
  const double tip_chord = p["tip_chord"] * root_chord;
  const double trailing = -0.5 * length + p["wing_rear"] * length;
  const double forward = p["trailing_sweep"] * half_span;
  const std::size_t first = assembly.mesh.face_count();
  const std::vector<Station> delta = {
      {Vec3(0.15 * r, 0, trailing + 0.5 * root_chord), root_chord, 0.055},
      {Vec3(half_span, -0.02 * half_span, trailing + forward + 0.5 * tip_chord), tip_chord, 0.05}};
  add_surface(assembly, wing, delta, Vec3::UnitY(), 7);
  mark_pair(assembly, wing_tip_left, wing, delta.back().middle);
  const double near = r * (1 + flat) / half_span;
  const double near_chord = root_chord + (tip_chord - root_chord) * near;
  mark_pair(assembly, wing_root_front_left, wing,
            Vec3(r * (1 + flat), 0, trailing + forward * near + near_chord));

  const bool canards = p.is("canards");
  const double tail_chord = (canards ? 0.26 : 0.36) * root_chord;
  const double tail_span = p["stabiliser_span"] * half_span + r * (1 + flat) * 0.5;
  const double tail_z = canards ? trailing + root_chord + 0.02 * length : -0.5 * length + 0.35 * tail_chord;
  const double tail_y = canards ? 0.35 * r : 0.0;
  const std::vector<Station> tailplane = {
      {Vec3(0.4 * r, tail_y, tail_z), tail_chord, 0.06},
      {Vec3(tail_span, tail_y, tail_z - 0.45 * tail_span), 0.4 * tail_chord, 0.06}};
  add_surface(assembly, stabiliser, tailplane, Vec3::UnitY(), 4);
  mark_pair(assembly, stabiliser_tip_left, stabiliser, tailplane.back().middle);

  // Air intakes beside the body, and the nozzles: all of the engine that shows.
  const double intake = 0.42 * r;
  const bool twin_engine = p.is("twin_engine");
  const double intake_length = 0.34 * length;
  const Vec3 intake_middle(r * (0.75 + 0.75 * flat), -0.22 * r, -0.02 * length);
  add_block(assembly, engine, Vec3(intake, 0.6 * r, 0.5 * intake_length), 0.3 * intake, {2, 2, 6},
            [=](const Vec3& q) {
              const double t =
                  0.5 + q.z() / intake_length;  // 1 at the intake's mouth, which is cut obliquely
              const double cut = q.y() / (0.6 * r) * 0.3 * intake;
              return Vec3(intake_middle + Vec3(q.x() * (0.8 + 0.2 * t), q.y() * (0.8 + 0.2 * t),
                                               q.z() + (t > 0.9 ? cut : 0.0)));
            });
  mark_pair(assembly, engine_front_left, engine, intake_middle + Vec3(0, 0, 0.5 * intake_length));
  const double nozzle = (twin_engine ? 0.46 : 0.68) * r;
  const Vec3 nozzle_origin(twin_engine ? 0.5 * r * (1 + 0.6 * flat) : 0, 0, -0.5 * length);
  const Profile outline = {{0.2 * nozzle, 0.02 * r},   {0.66 * nozzle, -0.1 * r},  {0.7 * nozzle, -0.62 * r},
                           {0.78 * nozzle, -0.62 * r}, {0.98 * nozzle, -0.15 * r}, {nozzle, 0.3 * r}};
  if (twin_engine) add_turned(assembly, engine, nozzle_origin, Vec3::UnitZ(), outline, 16);

  const double fin_height = p["fin_height"] * length;
  const double fin_chord = 0.36 * root_chord + 0.06 * length;
  const double cant = p["fin_cant"] * pi / 180;
  const bool twin_fins = p.is("twin_fins");
  const double fin_x = twin_fins ? 0.75 * r * (1 + flat) : 0;
  const Vec3 fin_up(twin_fins ? std::sin(cant) : 0, twin_fins ? std::cos(cant) : 1, 0);
  const Station fin_root{Vec3(fin_x, 0.45 * r, -0.5 * length + 0.62 * fin_chord), fin_chord, 0.07};
  const Station fin_end{fin_root.middle + fin_height * fin_up + Vec3(0, 0.4 * r, -0.55 * fin_height),
                        0.42 * fin_chord, 0.06};
  const Vec3 fin_side = twin_fins ? Vec3(-fin_up.y(), fin_up.x(), 0) : Vec3(-1, 0, 0);
  if (twin_fins) add_surface(assembly, rudder, {fin_root, fin_end}, fin_side, 5);
  add_mirrored(assembly, first);
  if (!twin_engine) add_turned(assembly, engine, nozzle_origin, Vec3::UnitZ(), outline, 20);
  if (!twin_fins) {
    add_surface(assembly, rudder, {fin_root, fin_end}, fin_side, 5);
    mark(assembly, rudder_top, rudder, fin_end.middle);
  }
  return assembly;
}

}  // namespace

Family planes() {
  return {
      .name = "planes",
      .shape = "plane",
      .labels = {{"body", false}, {"wing"}, {"stabiliser"}, {"rudder"}, {"engine"}},
      .landmarks = {"nose", "tail", "wing_tip_left", "wing_tip_right", "wing_root_front_left",
                    "wing_root_front_right", "stabiliser_tip_left", "stabiliser_tip_right", "rudder_top",
                    "engine_front_left", "engine_front_right"},
      .styles = {
          {"airliner",
           3,
           {{"length", normal(42, 7), "metres"},
            {"girth", uniform(0.088, 0.12), "diameter of the body over the length"},
            {"span", normal(0.92, 0.05), "over the length"},
            {"sweep", normal(29, 3), "of the leading edge, degrees"},
            {"dihedral", uniform(3, 7), "rise of the wings, degrees"},
            {"root_chord", normal(0.2, 0.012), "depth of the wing at the body, over the length"},
            {"tip_chord", uniform(0.2, 0.32), "over the root's"},
            {"wing_place", uniform(-0.01, 0.06), "of the wing's root before the middle, over the length"},
            {"winglets", chance(0.5), "the wing's tips are bent up"},
            {"engine_radius", uniform(0.42, 0.58), "over the body's"},
            {"engine_pairs", whole(1, 2), "pairs of engines below the wings"},
            {"engines_at_tail", chance(0.2), "one pair beside the tail instead"},
            {"t_tail", chance(0.15), "the stabiliser sits on top of the fin"},
            {"stabiliser_span", normal(0.37, 0.02), "over the wing's"},
            {"fin_height", normal(0.135, 0.01), "above the body, over the length"}},
           build_airliner},
          {"fighter",
           2,
           {{"length", normal(16, 1.5), "metres"},
            {"girth", uniform(0.085, 0.11), "height of the body over the length"},
            {"flatness", uniform(0, 0.7), "how much broader than high the body is behind, share"},
            {"span", normal(0.64, 0.05), "over the length"},
            {"root_chord", normal(0.46, 0.03), "depth of the wing at the axis, over the length"},
            {"tip_chord", uniform(0.08, 0.28), "over the root's"},
            {"wing_rear", uniform(0.1, 0.16), "of the wing's rear edge before the tail, over the length"},
            {"trailing_sweep", uniform(-0.1, 0.2), "how far the rear edge runs forward, over half the span"},
            {"canards", chance(0.3), "stabilisers before the wing, else behind it"},
            {"stabiliser_span", uniform(0.42, 0.52), "over the wing's"},
            {"twin_engine", chance(0.5), "two nozzles, else one"},
            {"twin_fins", chance(0.5), "two canted fins, else one"},
            {"fin_cant", uniform(0, 28), "of twin fins outwards, degrees"},
            {"fin_height", normal(0.14, 0.012), "over the length"}},
           build_fighter},
      }};
}

}  // namespace archetype
