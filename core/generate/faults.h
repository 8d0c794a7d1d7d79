// The faults that models from the web have, put into a clean one.
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/polygon_mesh.h"

namespace archetype {

// Each is the probability that a face has the fault, in [0, 1].
struct SoupFaults {
  double flipped = 0;       // turned inside out
  double duplicate = 0;     // there twice; every other copy is turned inside out
  double intersecting = 0;  // a copy stands across it
  double non_manifold = 0;  // a triangle stands on one of its edges, as the third face there
  double degenerate = 0;    // followed by a face without area: corners that are equal or lie on one line

  bool any() const {
    return flipped > 0 || duplicate > 0 || intersecting > 0 || non_manifold > 0 || degenerate > 0;
  }
  friend bool operator==(const SoupFaults&, const SoupFaults&) = default;
};

// Added faces stand right after the face that they belong to and have its label; no face is lost.
void add_faults(PolygonMesh& mesh, std::vector<int>& labels, const SoupFaults& faults, std::uint64_t seed);

}  // namespace archetype
