// Complete linkage in the principal directions of the box parameters.
#include "core/learning/arrangement_clusters.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace archetype {

namespace {

using Matrix = Eigen::MatrixXd;
using Clusters = std::vector<std::vector<std::size_t>>;

// Centres and half extents move together (a bench is wide in all its parts): few directions hold what tells
// arrangements apart.
constexpr Eigen::Index most_directions = 4;
constexpr std::size_t most_clusters = 6;

// One row per shape: the parts of `pattern` that are there.
Matrix arrangements(std::span<const std::vector<PartObservation>> observed,
                    const std::vector<std::size_t>& shapes, const std::vector<bool>& pattern) {
  const auto parts = std::count(pattern.begin(), pattern.end(), true);
  Matrix rows(static_cast<Eigen::Index>(shapes.size()), 6 * parts);
  for (Eigen::Index row = 0; row < rows.rows(); ++row) {
    Eigen::Index column = 0;
    for (std::size_t k = 0; k < pattern.size(); ++k) {
      if (!pattern[k]) continue;
      const Box& box = observed[shapes[static_cast<std::size_t>(row)]][k].box;
      rows.block<1, 3>(row, column) = box.centre.transpose();
      rows.block<1, 3>(row, column + 3) = box.half_extent.transpose();
      column += 6;
    }
  }
  return rows;
}

// The rows in their principal directions, the widest first.
Matrix principal(const Matrix& rows) {
  const Matrix centred = rows.rowwise() - rows.colwise().mean();
  const Eigen::SelfAdjointEigenSolver<Matrix> solver(centred.transpose() * centred);
  const Eigen::Index directions = std::min({most_directions, rows.cols(), rows.rows() - 1});
  return centred * solver.eigenvectors().rightCols(directions).rowwise().reverse();
}

// Merges the two clusters whose farthest members are nearest to each other.
void merge_nearest(const Matrix& points, Clusters& clusters) {
  double least = std::numeric_limits<double>::infinity();
  std::pair<std::size_t, std::size_t> nearest{0, 1};
  for (std::size_t a = 0; a < clusters.size(); ++a) {
    for (std::size_t b = a + 1; b < clusters.size(); ++b) {
      double farthest = 0;
      for (const std::size_t i : clusters[a]) {
        for (const std::size_t j : clusters[b]) {
          const auto difference =
              points.row(static_cast<Eigen::Index>(i)) - points.row(static_cast<Eigen::Index>(j));
          farthest = std::max(farthest, difference.squaredNorm());
        }
      }
      if (farthest < least) {
        least = farthest;
        nearest = {a, b};
      }
    }
  }
  auto& into = clusters[nearest.first];
  auto& from = clusters[nearest.second];
  into.insert(into.end(), from.begin(), from.end());
  clusters.erase(clusters.begin() + static_cast<std::ptrdiff_t>(nearest.second));
}

// Twice the negative log likelihood of one Gaussian per cluster, its variances per direction, and the cost of
// their parameters.
double information_criterion(const Matrix& points, const Clusters& clusters, double noise) {
  const auto n = static_cast<double>(points.rows());
  const auto directions = static_cast<double>(points.cols());
  double sum = std::log(n) * static_cast<double>(clusters.size()) * (2 * directions + 1);
  for (const auto& cluster : clusters) {
    const auto size = static_cast<double>(cluster.size());
    sum -= 2 * size * std::log(size / n);
    for (Eigen::Index d = 0; d < points.cols(); ++d) {
      double mean = 0;
      double square = 0;
      for (const std::size_t i : cluster) {
        const double value = points(static_cast<Eigen::Index>(i), d);
        mean += value / size;
        square += value * value / size;
      }
      sum += size * std::log(std::max(square - mean * mean, 0.0) + noise * noise);
    }
  }
  return sum;
}

// Indices into the rows of `points`.
Clusters best_cut(const Matrix& points, double noise) {
  Clusters clusters;
  for (std::size_t i = 0; i < static_cast<std::size_t>(points.rows()); ++i) clusters.push_back({i});
  Clusters best;
  double least = std::numeric_limits<double>::infinity();
  for (;;) {
    if (clusters.size() <= most_clusters) {
      const double criterion = information_criterion(points, clusters, noise);
      if (criterion < least) {
        least = criterion;
        best = clusters;
      }
    }
    if (clusters.size() == 1) return best;
    merge_nearest(points, clusters);
  }
}

}  // namespace

Clusters arrangement_clusters(std::span<const std::vector<PartObservation>> observed,
                              const LearnOptions& options) {
  std::map<std::vector<bool>, std::vector<std::size_t>> patterns;
  for (std::size_t i = 0; i < observed.size(); ++i) {
    std::vector<bool> pattern;
    for (const PartObservation& part : observed[i]) pattern.push_back(part.present);
    patterns[pattern].push_back(i);
  }
  Clusters result;
  for (const auto& [pattern, shapes] : patterns) {
    if (shapes.size() < options.smallest_cluster || std::ranges::count(pattern, true) == 0) continue;
    const Matrix points = principal(arrangements(observed, shapes, pattern));
    for (const auto& cluster : best_cut(points, options.arrangement_noise)) {
      if (cluster.size() < options.smallest_cluster) continue;
      std::vector<std::size_t>& members = result.emplace_back();
      for (const std::size_t i : cluster) members.push_back(shapes[i]);
      std::ranges::sort(members);
    }
  }
  std::ranges::stable_sort(result, std::greater<>{}, &std::vector<std::size_t>::size);
  return result;
}

}  // namespace archetype
