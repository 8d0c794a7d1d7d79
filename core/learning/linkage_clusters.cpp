// The two clusters whose farthest members are nearest to each other are merged, until `count` are left.
#include "core/learning/linkage_clusters.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>
#include <utility>

namespace archetype {

namespace {

using Clusters = std::vector<std::vector<std::size_t>>;

double farthest(const Eigen::MatrixXd& distances, const std::vector<std::size_t>& a,
                const std::vector<std::size_t>& b) {
  double result = 0;
  for (const std::size_t i : a) {
    for (const std::size_t j : b)
      result = std::max(result, distances(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
  }
  return result;
}

void merge_nearest(const Eigen::MatrixXd& distances, Clusters& clusters) {
  double least = std::numeric_limits<double>::infinity();
  std::pair<std::size_t, std::size_t> nearest{0, 1};
  for (std::size_t a = 0; a < clusters.size(); ++a) {
    for (std::size_t b = a + 1; b < clusters.size(); ++b) {
      const double apart = farthest(distances, clusters[a], clusters[b]);
      if (apart >= least) continue;
      least = apart;
      nearest = {a, b};
    }
  }
  auto& into = clusters[nearest.first];
  auto& from = clusters[nearest.second];
  into.insert(into.end(), from.begin(), from.end());
  clusters.erase(clusters.begin() + static_cast<std::ptrdiff_t>(nearest.second));
}

}  // namespace

std::vector<std::vector<std::size_t>> linkage_clusters(const Eigen::MatrixXd& points, std::size_t count) {
  Clusters clusters;
  for (std::size_t i = 0; i < static_cast<std::size_t>(points.rows()); ++i) clusters.push_back({i});
  Eigen::MatrixXd distances(points.rows(), points.rows());
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    distances.col(i) = (points.rowwise() - points.row(i)).rowwise().norm();
  while (clusters.size() > std::max<std::size_t>(count, 1)) merge_nearest(distances, clusters);
  for (auto& cluster : clusters) std::ranges::sort(cluster);
  return clusters;
}

Eigen::MatrixXd principal_directions(const Eigen::MatrixXd& rows, Eigen::Index directions) {
  const Eigen::MatrixXd centred = rows.rowwise() - rows.colwise().mean();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(centred.transpose() * centred);
  const Eigen::Index count = std::min(directions, rows.cols());
  return centred * solver.eigenvectors().rightCols(count).rowwise().reverse();
}

}  // namespace archetype
