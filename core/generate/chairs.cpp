// Chairs: plain ones, with arms, with high backs, benches, swivel chairs on a star base, bar stools.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "core/generate/family.h"

namespace archetype {

namespace {

enum Label { seat, back, leg, arm, stem, base };
enum Landmark {
  seat_front_left,
  seat_front_right,
  seat_back_left,
  seat_back_right,
  back_top_left,
  back_top_right,
  foot_front_left,
  foot_front_right,
  foot_back_left,
  foot_back_right,
  arm_front_left,
  arm_front_right,
  base_centre
};

// What the parts of one chair need to know of each other.
struct Chair {
  Assembly assembly;
  const ParameterValues& p;
  double half_width = 0;
  double half_depth = 0;
  double top = 0;        // height of the seat's upper side
  double underside = 0;  // and of its lower side
};

// A pair of landmarks, left at +x.
void mark_pair(Chair& chair, Landmark left, Label label, const Vec3& position) {
  chair.assembly.landmarks.push_back({static_cast<std::size_t>(left), label, position});
  chair.assembly.landmarks.push_back(
      {static_cast<std::size_t>(left) + 1, label, Vec3(-position.x(), position.y(), position.z())});
}

void add_seat(Chair& chair) {
  const ParameterValues& p = chair.p;
  const double thickness = p["seat_thickness"];
  const double crown = p["seat_crown"];
  const double taper = p["seat_taper"];
  chair.half_width = 0.5 * p["seat_width"];
  chair.half_depth = 0.5 * p["seat_depth"];
  chair.top = p["seat_height"];
  chair.underside = chair.top - thickness;
  const Vec3 half(chair.half_width, 0.5 * thickness, chair.half_depth);
  const double height = chair.top - 0.5 * thickness;
  const auto shape = [=](const Vec3& local) {
    const Vec2 u(local.x() / half.x(), local.z() / half.z());
    const double narrow = 1 - taper * 0.5 * (1 - u.y());
    const double bulge = local.y() > 0 ? crown * (1 - u.x() * u.x()) * (1 - u.y() * u.y()) : 0;
    return Vec3(local.x() * narrow, height + local.y() + bulge, local.z());
  };
  const int across = std::max(4, static_cast<int>(p["seat_width"] / 0.1));
  add_block(chair.assembly, seat, half, p["seat_rounding"] * thickness, {across, 1, 5}, shape);
  mark_pair(chair, seat_front_left, seat, Vec3(half.x(), chair.top, half.z()));
  mark_pair(chair, seat_back_left, seat, Vec3(half.x() * (1 - taper), chair.top, -half.z()));
}

Profile leg_profile(const ParameterValues& p) {
  const double half = 0.5 * p["leg_thickness"];
  return p.is("leg_round") ? ellipse(half, half, 12) : rounded_rectangle(half, half, 0.3 * half, 2);
}

// Four legs (six below long benches) with stretchers between them; all feet on the floor.
void add_legs(Chair& chair) {
  const ParameterValues& p = chair.p;
  Assembly& assembly = chair.assembly;
  const double inset = 0.6 * p["leg_thickness"];
  const double splay = p["leg_splay"];
  const double taper = p["seat_taper"];
  const Vec3 front(chair.half_width - inset, chair.underside + 0.004, chair.half_depth - inset);
  const Vec3 rear(chair.half_width * (1 - taper) - inset, front.y(), -front.z());
  const Vec3 front_foot(front.x() + splay, 0, front.z() + splay);
  const Vec3 rear_foot(rear.x() + splay, 0, rear.z() - splay);
  const Profile profile = leg_profile(p);

  std::size_t first = assembly.mesh.face_count();
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
    const Vec3 middle(0, 0, front.z());
    add_leg(assembly, leg, Vec3(0, front.y(), front.z()), Vec3(0, 0, front_foot.z()), profile,
            p["leg_taper"]);
    add_leg(assembly, leg, Vec3(0, front.y(), rear.z()), Vec3(0, 0, rear_foot.z()), profile, p["leg_taper"]);
  }
  mark_pair(chair, foot_front_left, leg, front_foot);
  mark_pair(chair, foot_back_left, leg, rear_foot);
}

// From back coordinates (x across, y up from the seat, z forward) to the chair: tilted, and bent about a
// vertical axis so that it embraces the sitter.
Placement back_placement(const Chair& chair) {
  const double tilt = chair.p["back_tilt"] * std::numbers::pi / 180;
  const double curve_depth = chair.p["back_curve"];
  const double half_width = chair.half_width;
  const double z = -chair.half_depth + 0.5 * chair.p["back_thickness"];
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

// Panel (0), upright slats between rails (1) or level rails (2); the two latter between posts.
void add_back(Chair& chair) {
  const ParameterValues& p = chair.p;
  const double height = p["back_height"];
  const double half_width = chair.half_width * (1 - p["seat_taper"]) * p["back_width"];
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

// An arm rest on a front post, or on a padded side panel that reaches down to the seat.
void add_arms(Chair& chair) {
  const ParameterValues& p = chair.p;
  if (!p.is("arms")) return;
  const double rest = chair.top + p["arm_height"];
  const double thickness = p["arm_thickness"];
  const double width = p["arm_width"];
  const double x = chair.half_width + 0.2 * width;
  const double front = chair.half_depth * (1 - p["arm_setback"]);
  const double rear = -chair.half_depth + 0.4 * p["back_thickness"] -
                      p["arm_height"] * std::tan(p["back_tilt"] * std::numbers::pi / 180);
  const std::size_t first = chair.assembly.mesh.face_count();
  const Vec3 from(x, rest - 0.5 * thickness, rear);
  const Vec3 to(x, rest - 0.5 * thickness, front);
  add_block(chair.assembly, arm, Vec3(0.5 * width, 0.5 * thickness, 0.5 * (front - rear)), 0.4 * thickness,
            {1, 1, 5}, along(from, to, Vec3::UnitY()));
  if (p.is("arm_panel")) {
    const double low = chair.underside + 0.3 * p["seat_thickness"];
    const Vec3 centre(x, 0.5 * (low + rest - thickness), 0.5 * (-chair.half_depth + front));
    add_block(chair.assembly, arm,
              Vec3(0.36 * width, 0.5 * (rest - thickness - low) + 0.004, 0.48 * (front + chair.half_depth)),
              0.1 * width, {1, 3, 5}, at(centre));
  } else {
    const double radius = 0.3 * std::min(thickness, width);
    const Vec3 foot(x - 0.5 * width, chair.top - 0.5 * p["seat_thickness"], 0.75 * front);
    add_tube(chair.assembly, arm,
             curve(foot, Vec3(x, 0.6 * chair.top + 0.4 * rest, 0.85 * front),
                   Vec3(x, rest - 0.6 * thickness, 0.82 * front), 6),
             std::vector<double>(6, radius), 8);
  }
  add_mirrored(chair.assembly, first);
  mark_pair(chair, arm_front_left, arm, Vec3(x, rest, front));
}

// A gas lift on a star of castors.
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

// A column on a plate.
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
}

// A ring or bars to put one's feet on.
void add_footrest(Chair& chair) {
  const ParameterValues& p = chair.p;
  const double y = p["footrest_level"] * chair.underside;
  const double radius = p.is("pedestal") ? 0.75 * chair.half_width : 0;
  const double tube = 0.011;
  if (radius == 0) return;
  const Vec3 forward(0, 0, 0.35 * radius);
  add_turned(chair.assembly, stem, Vec3(0, y, 0) + forward, Vec3::UnitY(),
             {{radius + tube, 0}, {radius, tube}, {radius - tube, 0}, {radius, -tube}}, 20, LoftEnds::joined);
  add_tube(chair.assembly, stem, Vec3(0, y, 0), Vec3(0, y, radius) + forward, 0.8 * tube, 8);
}

Assembly build_legged(const ParameterValues& parameters) {
  Chair chair{{}, parameters};
  add_seat(chair);
  add_legs(chair);
  if (parameters.find("has_back") == nullptr || parameters.is("has_back")) add_back(chair);
  add_arms(chair);
  return std::move(chair.assembly);
}

Assembly build_swivel(const ParameterValues& parameters) {
  Chair chair{{}, parameters};
  add_seat(chair);
  add_star_base(chair);
  add_back(chair);
  add_arms(chair);
  return std::move(chair.assembly);
}

Assembly build_stool(const ParameterValues& parameters) {
  Chair chair{{}, parameters};
  add_seat(chair);
  if (parameters.is("pedestal")) {
    add_pedestal(chair);
    add_footrest(chair);
  } else {
    add_legs(chair);
  }
  add_back(chair);
  return std::move(chair.assembly);
}

std::vector<Parameter> seat_parameters(Distribution width, Distribution depth, Distribution height) {
  return {{"seat_width", width, "metres"},
          {"seat_depth", depth, "metres"},
          {"seat_height", height, "of the upper side, metres"},
          {"seat_thickness", uniform(0.025, 0.08), "metres"},
          {"seat_rounding", uniform(0.1, 0.48), "radius of the edges over the thickness"},
          {"seat_crown", uniform(0, 0.02), "how far the middle of the seat rises, metres"},
          {"seat_taper", uniform(0, 0.16), "how much narrower the seat is behind, share"}};
}

std::vector<Parameter> leg_parameters() {
  return {{"leg_thickness", uniform(0.024, 0.05), "metres"},
          {"leg_taper", uniform(0.5, 1), "thickness at the foot over that at the top"},
          {"leg_splay", uniform(0, 0.07), "how far the feet stand out, metres"},
          {"leg_round", chance(0.5), "round legs, else square ones"},
          {"stretchers", chance(0.4), "bars between the legs"},
          {"stretcher_level", uniform(0.25, 0.55), "height of the bars over that of the legs"},
          {"stretcher_front", chance(0.4), "the cross bar joins the front legs, else the side bars"}};
}

std::vector<Parameter> back_parameters(Distribution height, Distribution kind) {
  return {{"back_height", height, "above the seat, metres"},
          {"back_width", uniform(0.85, 1), "over the width of the seat behind"},
          {"back_thickness", uniform(0.02, 0.05), "metres"},
          {"back_tilt", normal(10, 3.5), "degrees from upright"},
          {"back_curve", uniform(0, 0.06), "how far its middle lies behind its sides, metres"},
          {"back_kind", kind, "0: panel, 1: upright slats, 2: level rails"},
          {"back_gap", uniform(-0.1, 0.4), "open share between seat and panel; none below 0.05"},
          {"back_slats", whole(3, 6), "slats of a chair 0.44 m wide, or rails"}};
}

std::vector<Parameter> arm_parameters(Distribution arms) {
  return {{"arms", arms, "has arms"},
          {"arm_height", normal(0.21, 0.02), "above the seat, metres"},
          {"arm_thickness", uniform(0.025, 0.05), "metres"},
          {"arm_width", uniform(0.04, 0.08), "metres"},
          {"arm_setback", uniform(0, 0.35), "how far the arms end before the front, over half the depth"},
          {"arm_panel", chance(0.3), "closed below the rest, else on a post"}};
}

std::vector<Parameter> join(std::initializer_list<std::vector<Parameter>> lists) {
  std::vector<Parameter> joined;
  for (const auto& list : lists) joined.insert(joined.end(), list.begin(), list.end());
  return joined;
}

}  // namespace

Family chairs() {
  const auto plain_seat = seat_parameters(normal(0.45, 0.03), normal(0.44, 0.03), normal(0.45, 0.02));
  const auto plain_back = back_parameters(normal(0.44, 0.05), whole(0, 2));
  return {
      .name = "chairs",
      .shape = "chair",
      .labels = {{"seat", false}, {"back"}, {"leg"}, {"arm"}, {"stem"}, {"base"}},
      .landmarks = {"seat_front_left", "seat_front_right", "seat_back_left", "seat_back_right",
                    "back_top_left", "back_top_right", "foot_front_left", "foot_front_right",
                    "foot_back_left", "foot_back_right", "arm_front_left", "arm_front_right", "base_centre"},
      .styles = {
          {"plain", 3, join({plain_seat, leg_parameters(), plain_back, arm_parameters(chance(0))}),
           build_legged},
          {"arms", 3, join({plain_seat, leg_parameters(), plain_back, arm_parameters(chance(1))}),
           build_legged},
          {"high", 1,
           join({plain_seat, leg_parameters(), back_parameters(normal(0.78, 0.06), whole(0, 2)),
                 arm_parameters(chance(0.3))}),
           build_legged},
          {"bench", 1.5,
           join({seat_parameters(uniform(1, 1.8), normal(0.44, 0.03), normal(0.44, 0.02)),
                 leg_parameters(),
                 {{"has_back", chance(0.75), "has a back"}},
                 back_parameters(normal(0.42, 0.05), whole(0, 2)),
                 arm_parameters(chance(0.5))}),
           build_legged},
          {"swivel", 2,
           join({seat_parameters(normal(0.49, 0.025), normal(0.47, 0.025), normal(0.49, 0.03)),
                 {{"stem_radius", uniform(0.02, 0.032), "of the sleeve of the gas lift, metres"},
                  {"star_radius", normal(0.3, 0.02), "metres"},
                  {"star_arms", whole(4, 6), "arms of the base"},
                  {"castor_radius", uniform(0.02, 0.032), "metres"}},
                 back_parameters(normal(0.52, 0.06), whole(0, 0)),
                 arm_parameters(chance(0.6))}),
           build_swivel},
          {"stool", 1.5,
           join({seat_parameters(normal(0.39, 0.025), normal(0.38, 0.025), normal(0.72, 0.04)),
                 leg_parameters(),
                 {{"pedestal", chance(0.4), "stands on a column, else on legs"},
                  {"footrest_level", uniform(0.3, 0.45), "height of the ring over that of the column"}},
                 back_parameters(normal(0.24, 0.05), whole(0, 2))}),
           build_stool},
      }};
}

}  // namespace archetype
