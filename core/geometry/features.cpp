// Features from the covariance of neighbourhoods.
#include "core/geometry/features.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cstdint>

namespace archetype {

namespace {

// Points sorted into cells of which three or more have the width of the radius: neighbours lie at most three
// cells away. A neighbourhood has a hundred points or more, which a tree would visit one by one.
class Cells {
 public:
  Cells(std::span<const Vec3> points, double radius) {
    Vec3 highest = lowest_ = points.front();
    for (const Vec3& p : points) {
      lowest_ = lowest_.cwiseMin(p);
      highest = highest.cwiseMax(p);
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double extent = highest[static_cast<int>(axis)] - lowest_[static_cast<int>(axis)];
      const double wanted = radius > 0 ? cells_across * extent / (radius * slack) : most_cells;
      counts_[axis] = static_cast<int>(std::clamp(wanted, 1.0, static_cast<double>(most_cells)));
      per_unit_[static_cast<int>(axis)] = extent > 0 ? counts_[axis] / extent : 0;
    }
    begins_.assign(index({counts_[0] - 1, counts_[1] - 1, counts_[2] - 1}) + 2, 0);
    for (const Vec3& p : points) ++begins_[index(cell_of(p)) + 1];
    for (std::size_t c = 1; c < begins_.size(); ++c) begins_[c] += begins_[c - 1];
    std::vector<std::uint32_t> next(begins_.begin(), begins_.end() - 1);
    sorted_.resize(points.size());
    for (const Vec3& p : points) sorted_[next[index(cell_of(p))]++] = p;
  }

  // Runs of points of which all within the radius of `p` are part: along the last axis cells follow each
  // other.
  template <typename Visit>
  void visit_runs_about(const Vec3& p, const Visit& visit) const {
    const Cell middle = cell_of(p);
    const auto from = [&](std::size_t axis) { return std::max(middle[axis] - cells_across, 0); };
    const auto to = [&](std::size_t axis) {
      return std::min(middle[axis] + cells_across, counts_[axis] - 1);
    };
    for (int x = from(0); x <= to(0); ++x)
      for (int y = from(1); y <= to(1); ++y) {
        const std::uint32_t first = begins_[index({x, y, from(2)})];
        const std::uint32_t last = begins_[index({x, y, to(2)}) + 1];
        visit(std::span(sorted_).subspan(first, last - first));
      }
  }

 private:
  using Cell = std::array<int, 3>;
  static constexpr int cells_across = 3;       // the radius
  static constexpr int most_cells = 64;        // along an axis
  static constexpr double slack = 1.0 + 1e-9;  // rounding must not move a neighbour a cell too far

  Cell cell_of(const Vec3& p) const {
    const Vec3 at = (p - lowest_).cwiseProduct(per_unit_);
    Cell cell{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      cell[axis] = std::min(static_cast<int>(at[static_cast<int>(axis)]), counts_[axis] - 1);
    return cell;
  }
  std::size_t index(const Cell& cell) const {
    const auto along = [](int number) { return static_cast<std::size_t>(number); };
    return (along(cell[0]) * along(counts_[1]) + along(cell[1])) * along(counts_[2]) + along(cell[2]);
  }

  Vec3 lowest_;
  Vec3 per_unit_;
  std::array<int, 3> counts_{};
  std::vector<std::uint32_t> begins_;  // of each cell in sorted_, and its end
  std::vector<Vec3> sorted_;           // of one cell in the order given
};

// Of the points within `radius` of `p`, which is one of them. `offsets` is room for as many as there are.
Mat3 covariance_about(const Vec3& p, double radius, const Cells& cells, std::vector<Vec3>& offsets) {
  // A third of them lie within: which ones cannot be foreseen, and a branch on it costs more than the sums.
  std::size_t count = 0;
  cells.visit_runs_about(p, [&](std::span<const Vec3> run) {
    for (const Vec3& q : run) {
      offsets[count] = q - p;
      count += offsets[count].squaredNorm() <= radius * radius ? 1 : 0;
    }
  });
  Vec3 mean = Vec3::Zero();
  Vec3 squares = Vec3::Zero();
  Vec3 products = Vec3::Zero();
  for (const Vec3& d : std::span(offsets).first(count)) {
    mean += d;
    squares += d.cwiseProduct(d);
    products += d.cwiseProduct(Vec3(d[1], d[2], d[0]));
  }
  Mat3 moment = squares.asDiagonal();
  moment(0, 1) = moment(1, 0) = products[0];
  moment(1, 2) = moment(2, 1) = products[1];
  moment(2, 0) = moment(0, 2) = products[2];
  mean /= static_cast<double>(count);
  return moment / static_cast<double>(count) - mean * mean.transpose();
}

}  // namespace

PointFeatures compute_features(std::span<const Vec3> points, double radius) {
  PointFeatures result;
  result.x.resize(points.size());
  result.z.resize(points.size());
  if (points.empty()) return result;
  const Cells cells(points, radius);
  std::vector<Vec3> offsets(points.size() + 1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    Eigen::SelfAdjointEigenSolver<Mat3> solver;
    solver.computeDirect(covariance_about(points[i], radius, cells, offsets));
    const Vec3 l = solver.eigenvalues().cwiseMax(0.0);  // increasing
    if (!(l[2] > 0)) continue;                          // a lone point has no local shape
    const Vec3 v1 = solver.eigenvectors().col(2);
    const Vec3 v3 = solver.eigenvectors().col(0);
    const double stick = (l[2] - l[1]) / l[2];
    const double plate = (l[1] - l[0]) / l[2];
    const auto features = [&](int a2) {
      return Features{l[1] / l[2],           l[0] / l[2],
                      stick * v1[1] * v1[1], stick * v1[a2] * v1[a2],
                      plate * v3[1] * v3[1], plate * v3[a2] * v3[a2]};
    };
    result.x[i] = features(0);
    result.z[i] = features(2);
  }
  return result;
}

}  // namespace archetype
