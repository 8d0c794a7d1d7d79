// Shapes with parts that lie and are sized as somebody wants them to (figure 9: what a collection varies in).
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/session/fit_table.h"

namespace archetype {

inline constexpr std::size_t part_parameter_count = 6;  // centre x, y, z and half extent x, y, z

// Wished values of one part's parameters, in the template's standard deviations from its mean. Nothing: any.
using PartWish = std::array<std::optional<double>, part_parameter_count>;

bool is_any(const PartWish& wish);

// Of a part on a shape, in the template's standard deviations from its mean, but within ±1000.
std::array<double, part_parameter_count> part_parameters(const TemplatePart& part, const Box& fitted);

// The template with its mean boxes where the wishes have them. One wish per part, or fewer.
PartTemplate wished_template(const PartTemplate& part_template, std::span<const PartWish> wishes);

struct NearShape {
  ShapeId shape = 0;
  double distance = 0;  // root of the mean square over what was wished, in standard deviations
  friend bool operator==(const NearShape&, const NearShape&) = default;
};

// Of the shapes fitted by one template, at most `count`, the nearest first; of equally near ones those that
// fit better. A part that a shape lacks counts as four deviations away in all that is wished of it. Without
// any wish the shapes nearest to the mean of the template come, counting all present parts. Cost: the number
// of shapes times that of wishes (or of all parameters).
std::vector<NearShape> nearest_shapes(const FitTable& table, std::size_t part_template,
                                      std::span<const PartWish> wishes, std::size_t count);

}  // namespace archetype
