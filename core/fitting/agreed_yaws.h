// Which way the shapes of a collection face, decided together.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/base/job_control.h"
#include "core/model/shape.h"

namespace archetype {

// How much of a shape's surface lies where and faces which way, for each of the four yaws: root densities
// over cells of its bounds and axes of normals, so that the dot product of two is 1 for shapes that are alike
// and 0 for shapes that have nothing in common.
using FacingPicture = std::vector<float>;
std::array<FacingPicture, 4> facing_pictures(const ShapeSamples& samples);

// Adds to the energies or costs of the yaws of a shape what the others cost where one is known; nothing
// where none is.
void add_cost_of_turning(std::array<double, 4>& costs, std::optional<int> known);

// Goes beyond the paper, which takes the yaw of the least energy for each shape alone: a template of chairs
// reaches a bench better from the side, and a desk lamp from anywhere. Here the references that look most
// like a shape vote on how it stands; what they say counts beside the energies of its fits. References are
// turned one after the other until none turns any more.
class AgreedYaws {
 public:
  // More references than this make no difference.
  static constexpr std::size_t most_references = 64;

  // energies: those that the fits of each reference reached in each yaw; infinite where not known, but not
  // all four. Some ms per reference. To be left alone if cancelled.
  AgreedYaws(std::span<const ShapeSamples> references, std::span<const std::array<double, 4>> energies,
             const JobControl& control = {});

  // What each yaw of a shape costs beside its energy (FitOptions::yaw_costs): 0 for the one that the
  // references are for, infinite where they are so clearly against it that it need not be tried. All 0 if
  // there are too few to ask. About 1 ms.
  std::array<double, 4> costs(const ShapeSamples& samples) const;

 private:
  std::array<double, 4> costs(const std::array<FacingPicture, 4>& pictures, std::size_t without) const;

  std::vector<FacingPicture> references_;  // turned as agreed
};

}  // namespace archetype
