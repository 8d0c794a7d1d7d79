// Groups of shapes whose parts are arranged alike ("Template spawning" of section 4.2).
#pragma once

#include <span>
#include <vector>

#include "core/learning/learn_options.h"
#include "core/learning/reestimate.h"

namespace archetype {

// Clusters of the shapes in `observed` (one entry per shape, each with one observation per part), as sorted
// indices, the largest cluster first. Shapes of one cluster have the same parts; complete linkage over the
// centres and sizes of these, and their number by the Bayesian information criterion. Shapes in clusters
// below options.smallest_cluster are left out. Cubic in the number of shapes: for hundreds, not thousands.
std::vector<std::vector<std::size_t>> arrangement_clusters(
    std::span<const std::vector<PartObservation>> observed, const LearnOptions& options);

}  // namespace archetype
