// What fitting one template to one shape found: the free variables of section 4.1.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/box.h"

namespace archetype {

inline constexpr std::int16_t null_label = -1;  // a sample that belongs to no part

// The terms of the energy (equation 1), each as it enters the sum: weights are already applied.
struct FitEnergy {
  double shape_to_template = 0;  // equation 3
  double template_to_shape = 0;  // equation 4
  double features = 0;           // equation 5, with gamma and the cost of null points
  double deformation = 0;        // equation 6, with alpha
  double smoothness = 0;         // equation 7, with beta
  double existence = 0;          // ours: -log of the probability of the parts being there or not

  double data() const { return shape_to_template + template_to_shape + features; }
  double total() const { return data() + deformation + smoothness + existence; }
  friend bool operator==(const FitEnergy&, const FitEnergy&) = default;
};

// Turns by quarter turns about +y, exactly; one takes +z to +x.
Vec3 turn_quarters(const Vec3& p, int quarters);

struct FittedPart {
  bool present = false;
  Box box;  // in the template's frame; the mean box where the part is absent
};

// The template stands in its own frame; the shape is turned into it: q = R_y(-yaw) * p - translation.
struct ShapeFit {
  int yaw_quarters = 0;              // 0..3: the shape stands turned by that many quarter turns about +y
  Vec3 translation = Vec3::Zero();   // of the template on the turned shape, normalised units
  std::vector<FittedPart> parts;     // one per template part
  std::vector<std::int16_t> labels;  // one per sample: part index, or null_label
  FitEnergy energy;
  int alternations = 0;
  bool converged = false;  // the labels stopped changing
  // Total energy that each yaw reached before parts without evidence were left out, but for those that hardly
  // any shape has (fit_template.h). Infinite where not tried.
  std::array<double, 4> yaw_energies{};

  std::vector<Box> boxes() const;  // one per template part

  Vec3 to_template(const Vec3& p) const;
  std::vector<Vec3> to_template(std::span<const Vec3> points) const;
  Vec3 to_shape(const Vec3& q) const;
};

}  // namespace archetype
