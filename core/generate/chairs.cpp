// Chairs: plain ones, with arms, with high backs, benches, swivel chairs on a star base, bar stools.
#include "core/generate/chair_parts.h"

namespace archetype {

namespace {

using namespace chair_parts;

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
  } else {
    add_legs(chair);
  }
  add_back(chair);
  return std::move(chair.assembly);
}

std::vector<Parameter> seat_parameters(Distribution width, Distribution depth, Distribution height,
                                       Distribution roundness) {
  return {{"seat_width", width, "metres"},
          {"seat_depth", depth, "metres"},
          {"seat_height", height, "of the upper side, metres"},
          {"seat_thickness", uniform(0.025, 0.08), "metres"},
          {"seat_rounding", uniform(0.1, 0.48), "radius of the edges over the thickness"},
          {"seat_roundness", roundness, "0: straight sides, 1: an ellipse"},
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
  const auto plain_seat =
      seat_parameters(normal(0.45, 0.03), normal(0.44, 0.03), normal(0.45, 0.02), uniform(0, 0.35));
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
           join({seat_parameters(uniform(1, 1.8), normal(0.44, 0.03), normal(0.44, 0.02), uniform(0, 0.08)),
                 leg_parameters(),
                 {{"has_back", chance(0.75), "has a back"}},
                 back_parameters(normal(0.42, 0.05), whole(0, 2)),
                 arm_parameters(chance(0.5))}),
           build_legged},
          {"swivel", 2,
           join({seat_parameters(normal(0.49, 0.025), normal(0.47, 0.025), normal(0.49, 0.03),
                                 uniform(0.1, 0.5)),
                 {{"stem_radius", uniform(0.02, 0.032), "of the sleeve of the gas lift, metres"},
                  {"star_radius", normal(0.3, 0.02), "metres"},
                  {"star_arms", whole(4, 6), "arms of the base"},
                  {"castor_radius", uniform(0.02, 0.032), "metres"}},
                 back_parameters(normal(0.52, 0.06), whole(0, 0)),
                 arm_parameters(chance(0.6))}),
           build_swivel},
          {"stool", 1.5,
           join({seat_parameters(normal(0.39, 0.025), normal(0.38, 0.025), normal(0.72, 0.04), uniform(0, 1)),
                 leg_parameters(),
                 {{"pedestal", chance(0.4), "stands on a column, else on legs"},
                  {"footrest_level", uniform(0.3, 0.45), "height of the ring over that of the column"}},
                 back_parameters(normal(0.24, 0.05), whole(0, 2))}),
           build_stool},
      }};
}

}  // namespace archetype
