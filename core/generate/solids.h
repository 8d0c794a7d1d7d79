// The closed solids that generated shapes are put together from: rounded blocks, lofts, turned bodies, tubes.
// All have their faces turned outwards; solids of one shape touch or intersect, as in models made by people.
#pragma once

#include <functional>
#include <vector>

#include "core/geometry/polygon_mesh.h"

namespace archetype {

using Vec2 = Eigen::Vector2d;
using Profile = std::vector<Vec2>;  // a polygon in the plane, counter-clockwise
using Ring = std::vector<Vec3>;     // a closed polygon in space
using Placement = std::function<Vec3(const Vec3&)>;

// A mark at a place that corresponds over all shapes of a family. It goes with the part: no part, no
// landmark.
struct PlacedLandmark {
  std::size_t index = 0;         // into the family's landmark names
  int label = 0;                 // the part whose surface it lies on
  Vec3 position = Vec3::Zero();  // on or near that surface
};

// A shape while it is built.
struct Assembly {
  PolygonMesh mesh;
  std::vector<int> labels;  // one per face
  std::vector<PlacedLandmark> landmarks;
};

Profile ellipse(double radius_x, double radius_y, int sides);
// Between an ellipse (exponent 2) and a rectangle (large exponents).
Profile superellipse(double radius_x, double radius_y, double exponent, int sides);
Profile rounded_rectangle(double half_x, double half_y, double radius, int corner_segments);
// A symmetric wing section (the four-digit NACA thickness) with its leading edge at x = chord/2.
Profile wing_section(double chord, double thickness_share, int points_per_side);

// The profile in space: x along u, y along v. A loft of such rings runs along u × v.
Ring place(const Profile& profile, const Vec3& origin, const Vec3& u, const Vec3& v);

enum class LoftEnds { capped, joined };  // joined: the last ring meets the first
// Rings of equal size, each counter-clockwise about the direction that the loft takes.
void add_loft(Assembly& assembly, int label, const std::vector<Ring>& rings,
              LoftEnds ends = LoftEnds::capped);

// A body turned on a lathe: profile points are (radius, distance along the axis), outside first. An outline
// that ends where it began (LoftEnds::joined) makes a hollow shade or a torus.
void add_turned(Assembly& assembly, int label, const Vec3& origin, const Vec3& axis, const Profile& outline,
                int sides, LoftEnds ends = LoftEnds::capped);

// A round bar along a path of at least two points; one radius per point.
void add_tube(Assembly& assembly, int label, const std::vector<Vec3>& path, const std::vector<double>& radii,
              int sides);
void add_tube(Assembly& assembly, int label, const Vec3& from, const Vec3& to, double radius, int sides);

// A leg: the profile (x, z) at the top and, scaled, at the foot; both ends are cut level.
void add_leg(Assembly& assembly, int label, const Vec3& top, const Vec3& foot, const Profile& profile,
             double foot_scale);

// A box of half extents `half` about the origin with rounded edges, its sides cut into `cells` quads, put in
// place point by point (bent, tapered) by `placement`. The bevel is at most the least half extent.
void add_block(Assembly& assembly, int label, const Vec3& half, double bevel, const std::array<int, 3>& cells,
               const Placement& placement);

Placement at(const Vec3& centre);
// z runs from one point to the other, their middle is the origin; y is as near to `up` as that allows.
Placement along(const Vec3& from, const Vec3& to, const Vec3& up);

// Adds the mirror image (x negated) of all that was added since `first_face`.
void add_mirrored(Assembly& assembly, std::size_t first_face);

// A quadratic Bézier curve in `points` points.
std::vector<Vec3> curve(const Vec3& from, const Vec3& towards, const Vec3& to, int points);

}  // namespace archetype
