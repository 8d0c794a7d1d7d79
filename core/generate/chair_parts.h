// The parts that chairs are put together from.
#pragma once

#include "core/generate/family.h"

namespace archetype::chair_parts {

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

// What the parts of one chair need to know of each other. Start it with add_seat().
struct Chair {
  Assembly assembly;
  const ParameterValues& p;
  double half_width = 0;
  double half_depth = 0;
  double top = 0;        // height of the seat's upper side
  double underside = 0;  // and of its lower side
  double corner = 1;  // how far out the corners of the rounded seat lie, as a share of half width and depth
};

void add_seat(Chair& chair);
// Four legs (six below long benches) with stretchers between them; all feet on the floor.
void add_legs(Chair& chair);
// Panel (0), upright slats between rails (1) or level rails (2); the two latter between posts.
void add_back(Chair& chair);
// Arm rests on front posts, or on padded side panels that reach down to the seat.
void add_arms(Chair& chair);
// A gas lift on a star of castors.
void add_star_base(Chair& chair);
// A column on a plate, with a ring to put one's feet on.
void add_pedestal(Chair& chair);

}  // namespace archetype::chair_parts
