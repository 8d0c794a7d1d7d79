// Clusters of points.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace archetype {

// The indices of the rows of `points` in `count` clusters (or as many as there are rows), each sorted, by
// complete linkage ("Template spawning" of section 4.2). Cubic in the number of rows: for hundreds, not
// thousands.
std::vector<std::vector<std::size_t>> linkage_clusters(const Eigen::MatrixXd& points, std::size_t count);

// The rows in their principal directions, the widest first; `directions` at most.
Eigen::MatrixXd principal_directions(const Eigen::MatrixXd& rows, Eigen::Index directions);

}  // namespace archetype
