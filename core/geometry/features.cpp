// Features from the covariance of neighbourhoods.
#include "core/geometry/features.h"

#include <Eigen/Eigenvalues>

#include "core/geometry/kd_tree.h"

namespace archetype {

PointFeatures compute_features(std::span<const Vec3> points, double radius) {
  PointFeatures result;
  result.x.resize(points.size());
  result.z.resize(points.size());
  if (points.empty()) return result;
  const KdTree tree(points);
  std::vector<KdTree::Neighbour> found;
  for (std::size_t i = 0; i < points.size(); ++i) {
    tree.within(points[i], radius, found);
    Vec3 mean = Vec3::Zero();
    Mat3 moment = Mat3::Zero();
    for (const auto& f : found) {
      const Vec3 d = points[f.index] - points[i];
      mean += d;
      moment.noalias() += d * d.transpose();
    }
    const auto n = static_cast<double>(found.size());
    mean /= n;
    const Mat3 covariance = moment / n - mean * mean.transpose();
    Eigen::SelfAdjointEigenSolver<Mat3> solver;
    solver.computeDirect(covariance);
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
