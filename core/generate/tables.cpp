// Tables: on four legs, on a pedestal, on trestles.
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "core/generate/family.h"

namespace archetype {

namespace {

enum Label { top, leg, stem, base };
enum Landmark {
  top_front_left,
  top_front_right,
  top_back_left,
  top_back_right,
  top_centre,
  foot_front_left,
  foot_front_right,
  foot_back_left,
  foot_back_right,
  base_centre
};

struct Table {
  Assembly assembly;
  const ParameterValues& p;
  double half_length = 0;  // along x
  double half_depth = 0;   // along z
  double height = 0;
  double underside = 0;
};

void mark(Table& table, Landmark landmark, Label label, const Vec3& position) {
  table.assembly.landmarks.push_back({static_cast<std::size_t>(landmark), label, position});
}

// Left, and right (the next landmark) as its mirror image.
void mark_pair(Table& table, Landmark left, Label label, const Vec3& position) {
  table.assembly.landmarks.push_back({static_cast<std::size_t>(left), label, position});
  table.assembly.landmarks.push_back(
      {static_cast<std::size_t>(left) + 1, label, Vec3(-position.x(), position.y(), position.z())});
}

// A slab between a rectangle and an ellipse. Its corners carry the landmarks: for a round top these are the
// points in the diagonal directions.
Table start_table(const ParameterValues& p) {
  Table table{{}, p};
  table.half_length = 0.5 * p["top_length"];
  table.half_depth = 0.5 * p["top_depth"];
  table.height = p["height"];
  const double thickness = p["top_thickness"];
  table.underside = table.height - thickness;
  const bool round = p.is("top_round");
  const double bevel = p["top_bevel"] * thickness;
  const auto outline = [&](double inset) {
    const double a = table.half_length - inset;
    const double b = table.half_depth - inset;
    return round ? ellipse(a, b, 40) : rounded_rectangle(a, b, p["top_corner"], 4);
  };
  std::vector<Ring> rings;
  const auto ring = [&](double inset, double y) {
    rings.push_back(place(outline(inset), Vec3(0, y, 0), Vec3::UnitX(), -Vec3::UnitZ()));
  };
  const double mid = 0.5 * std::min(table.half_length, table.half_depth);
  ring(mid, table.underside);
  ring(bevel, table.underside);
  ring(0, table.underside + bevel);
  ring(0, table.height - bevel);
  ring(bevel, table.height);
  ring(mid, table.height);
  add_loft(table.assembly, top, rings);

  const double corner = round ? std::numbers::sqrt2 / 2 : 1;
  mark_pair(table, top_front_left, top,
            Vec3(corner * table.half_length, table.height, corner * table.half_depth));
  mark_pair(table, top_back_left, top,
            Vec3(corner * table.half_length, table.height, -corner * table.half_depth));
  mark(table, top_centre, top, Vec3(0, table.height, 0));
  return table;
}

Assembly build_four_legs(const ParameterValues& p) {
  Table table = start_table(p);
  const double half = 0.5 * p["leg_thickness"];
  const double reach = p.is("top_round") ? 0.62 : 1;
  const double inset = half + p["leg_inset"];
  const Vec3 from(reach * table.half_length - inset, table.underside + 0.003,
                  reach * table.half_depth - inset);
  const Vec3 foot(from.x() + p["leg_splay"], 0, from.z() + p["leg_splay"]);
  const std::size_t first = table.assembly.mesh.face_count();
  const Profile profile =
      p.is("leg_round") ? ellipse(half, half, 14) : rounded_rectangle(half, half, 0.25 * half, 2);
  for (const double side : {1.0, -1.0}) {
    add_leg(table.assembly, leg, Vec3(from.x(), from.y(), side * from.z()),
            Vec3(foot.x(), 0, side * foot.z()), profile, p["leg_taper"]);
  }
  const double apron = p["apron_height"];
  if (p.is("apron")) {
    add_block(table.assembly, top, Vec3(0.009, 0.5 * apron, from.z()), 0.003, {1, 1, 3},
              at(Vec3(from.x(), table.underside + 0.002 - 0.5 * apron, 0)));
  }
  add_mirrored(table.assembly, first);
  if (p.is("apron")) {
    for (const double side : {1.0, -1.0}) {
      add_block(table.assembly, top, Vec3(from.x(), 0.5 * apron, 0.009), 0.003, {5, 1, 1},
                at(Vec3(0, table.underside + 0.002 - 0.5 * apron, side * from.z())));
    }
  }
  mark_pair(table, foot_front_left, leg, foot);
  mark_pair(table, foot_back_left, leg, Vec3(foot.x(), 0, -foot.z()));
  return std::move(table.assembly);
}

// A turned column on a plate or on curved feet.
Assembly build_pedestal(const ParameterValues& p) {
  Table table = start_table(p);
  const double thick = p["stem_radius"];
  const double swell = p["stem_swell"];
  const double foot_height = p.is("base_plate") ? 0.03 : 0.12;
  const double reach = p["base_share"] * std::min(table.half_length, table.half_depth);
  Profile column;
  constexpr int steps = 12;
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    const double bulge = 1 + swell * std::sin(2 * std::numbers::pi * t) * (1 - 0.5 * t);
    column.emplace_back(thick * bulge, foot_height + t * (table.underside - 0.02 - foot_height));
  }
  column.emplace_back(2.6 * thick, table.underside - 0.015);
  column.emplace_back(2.6 * thick, table.underside + 0.002);
  add_turned(table.assembly, stem, Vec3::Zero(), Vec3::UnitY(), column, 18);

  if (p.is("base_plate")) {
    add_turned(
        table.assembly, base, Vec3::Zero(), Vec3::UnitY(),
        {{0.96 * reach, 0}, {reach, 0.008}, {0.97 * reach, 0.018}, {0.5 * reach, 0.03}, {1.3 * thick, 0.055}},
        28);
  } else {
    add_turned(table.assembly, base, Vec3::Zero(), Vec3::UnitY(),
               {{0.8 * thick, 0.07}, {1.3 * thick, 0.09}, {1.3 * thick, 0.2}, {1.05 * thick, 0.22}}, 18);
    const int feet = static_cast<int>(p["base_feet"]);
    for (int i = 0; i < feet; ++i) {
      const double angle = 2 * std::numbers::pi * (i + 0.5) / feet;
      const Vec3 out(std::sin(angle), 0, std::cos(angle));
      const Vec3 side = Vec3::UnitY().cross(out);
      const std::vector<Vec3> path =
          curve(0.6 * thick * out + 0.16 * Vec3::UnitY(), 0.45 * reach * out + 0.17 * Vec3::UnitY(),
                reach * out + 0.022 * Vec3::UnitY(), 8);
      std::vector<Ring> rings;
      for (std::size_t k = 0; k < path.size(); ++k) {
        const double scale = 1 - 0.055 * static_cast<double>(k);
        rings.push_back(
            place(rounded_rectangle(0.024 * scale, 0.035 * scale, 0.012, 2), path[k], side, Vec3::UnitY()));
      }
      add_loft(table.assembly, base, rings);
    }
  }
  mark(table, base_centre, base, Vec3::Zero());
  return std::move(table.assembly);
}

// Two trestles, each two splayed legs with a foot bar and a head, joined by a beam.
Assembly build_trestle(const ParameterValues& p) {
  Table table = start_table(p);
  const double half = 0.5 * p["leg_thickness"];
  const double x = table.half_length * p["trestle_place"];
  const double spread = p["trestle_spread"] * table.half_depth;
  const double head = 0.85 * table.half_depth;
  const double crossing = p.is("crossed") ? -1 : 0.35;
  const std::size_t first = table.assembly.mesh.face_count();
  const Profile profile = rounded_rectangle(0.8 * half, half, 0.25 * half, 2);
  for (const double side : {1.0, -1.0}) {
    add_leg(table.assembly, leg, Vec3(x, table.underside - half, side * crossing * 0.8 * spread),
            Vec3(x, 0, side * spread), profile, 0.9);
  }
  add_block(table.assembly, leg, Vec3(half, 0.9 * half, head), 0.3 * half, {1, 1, 6},
            at(Vec3(x, table.underside - 0.88 * half, 0)));
  add_mirrored(table.assembly, first);
  const double level = p["beam_level"] * table.height;
  const double width_there = 0.5 * half;
  add_block(table.assembly, leg, Vec3(x, p["beam_height"] / 2, width_there), 0.2 * width_there, {8, 1, 1},
            at(Vec3(0, level, 0)));
  if (!p.is("crossed")) {
    // The bar of the A, where the beam rests.
    const double reach = spread * (1 - level / table.height) + 0.35 * 0.8 * spread * level / table.height;
    for (const double side : {1.0, -1.0}) {
      add_block(table.assembly, leg, Vec3(0.5 * half, 0.7 * half, reach), 0.2 * half, {1, 1, 4},
                at(Vec3(side * x, level, 0)));
    }
  }
  mark_pair(table, foot_front_left, leg, Vec3(x, 0, spread));
  mark_pair(table, foot_back_left, leg, Vec3(x, 0, -spread));
  return std::move(table.assembly);
}

std::vector<Parameter> with_top(Distribution length, Distribution depth, Distribution round,
                                std::vector<Parameter> rest) {
  std::vector<Parameter> all = {{"top_length", length, "metres"},
                                {"top_depth", depth, "metres"},
                                {"height", normal(0.74, 0.025), "metres"},
                                {"top_thickness", uniform(0.02, 0.055), "metres"},
                                {"top_round", round, "an ellipse, else a rectangle"},
                                {"top_corner", uniform(0.005, 0.12), "radius of the corners, metres"},
                                {"top_bevel", uniform(0.1, 0.4), "of the edges, over the thickness"}};
  all.insert(all.end(), rest.begin(), rest.end());
  return all;
}

}  // namespace

Family tables() {
  const Parameter leg_thickness = {"leg_thickness", uniform(0.04, 0.085), "metres"};
  return {.name = "tables",
          .shape = "table",
          .labels = {{"top", false}, {"leg"}, {"stem"}, {"base"}},
          .landmarks = {"top_front_left", "top_front_right", "top_back_left", "top_back_right", "top_centre",
                        "foot_front_left", "foot_front_right", "foot_back_left", "foot_back_right",
                        "base_centre"},
          .styles = {
              {"legs", 3,
               with_top(uniform(0.9, 2), normal(0.82, 0.06), chance(0.2),
                        {leg_thickness,
                         {"leg_taper", uniform(0.5, 1), "thickness at the foot over that at the top"},
                         {"leg_inset", uniform(0.005, 0.07), "of the legs from the edge, metres"},
                         {"leg_splay", uniform(-0.01, 0.06), "how far the feet stand out, metres"},
                         {"leg_round", chance(0.4), "round legs, else square ones"},
                         {"apron", chance(0.7), "boards below the top (labelled top)"},
                         {"apron_height", uniform(0.06, 0.12), "metres"}}),
               build_four_legs},
              {"pedestal", 2,
               with_top(uniform(0.8, 1.2), uniform(0.8, 1.2), chance(0.8),
                        {{"stem_radius", uniform(0.03, 0.06), "metres"},
                         {"stem_swell", uniform(0, 0.5), "of the turned column, share of its radius"},
                         {"base_plate", chance(0.5), "stands on a plate, else on curved feet"},
                         {"base_share", uniform(0.55, 0.8),
                          "radius of the base over half the lesser side of the top"},
                         {"base_feet", whole(3, 4), "curved feet"}}),
               build_pedestal},
              {"trestle", 2,
               with_top(uniform(1.4, 2.2), normal(0.85, 0.06), chance(0),
                        {leg_thickness,
                         {"trestle_place", uniform(0.6, 0.82), "from the middle, over half the length"},
                         {"trestle_spread", uniform(0.7, 0.9), "of the feet, over the depth"},
                         {"crossed", chance(0.4), "X trestles, else A trestles"},
                         {"beam_level", uniform(0.35, 0.5), "height of the beam over that of the table"},
                         {"beam_height", uniform(0.05, 0.1), "metres"}}),
               build_trestle},
          }};
}

}  // namespace archetype
