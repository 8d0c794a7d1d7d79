// The alternation of section 4.1 written down plainly: the second implementation that ours is checked and
// timed against.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/fitting/alpha_expansion.h"
#include "core/fitting/fit_options.h"
#include "core/model/part_template.h"
#include "core/model/shape.h"
#include "core/model/shape_fit.h"

namespace archetype::test {

// Boost's Boykov-Kolmogorov max-flow for each expansion move, every node in every cut. Starts from the labels
// given.
std::int64_t plain_expand_labels(const LabellingGraph& graph, const LabelCosts& unary,
                                 std::size_t label_count, std::span<std::int16_t> labels);

// No pruning, no warm start (each labelling begins at the cheapest labels), brute-force neighbours.
ShapeFit plain_fit(const PartTemplate& part_template, const ShapeSamples& samples, const FitOptions& options);

}  // namespace archetype::test
