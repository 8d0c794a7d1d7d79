// Which parts of a fit are round.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/fitting/deformation.h"

namespace archetype {

inline constexpr std::array round_solids{Solid::ellipsoid, Solid::cylinder_x, Solid::cylinder_y,
                                         Solid::cylinder_z};

// Matches boxes with the samples, whose labels stay (correspondence.h).
using MatchBoxes = std::function<void(std::span<const Box>, Correspondences&)>;

// For each part, the box as it stands or the round solid in a box of its own that lowers the part's share of
// E_s->t + E_t->s to options.round_share at least, and of the energy with labels as they are at all; nothing
// if all stay. Parts that are round already stay so. shape.matches: of `boxes`. About as long as two
// alternations.
// Differs from the paper, whose parts are boxes: to a vase's body a box stays so far away that a handle is
// worth no more than that. Which solid it is, each shape decides by itself: bodies of vases are round on one
// and straight on the next. (Vases, accuracy by area with a template made by hand: 82.4 % with boxes, 81.2 to
// 82.4 % with a round solid for the template, 84.3 % so.)
std::optional<std::vector<Box>> choose_solids(const MatchedShape& shape, const PartTemplate& part_template,
                                              std::span<const Box> boxes, const FitOptions& options,
                                              const MatchBoxes& match);

}  // namespace archetype
