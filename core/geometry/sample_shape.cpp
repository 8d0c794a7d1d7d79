// Sampling, normalisation, normals and features of one shape.
#include "core/geometry/sample_shape.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/geometry/blue_noise.h"
#include "core/geometry/features.h"
#include "core/geometry/kd_tree.h"
#include "core/geometry/straighten.h"

namespace archetype {

namespace {

// Candidates per sample before elimination; Yuksel uses 3 to 5; 3 costs a third less than 4.
constexpr int oversampling = 3;

struct Candidates {
  std::vector<Vec3> points;
  std::vector<Vec3> normals;
  std::vector<std::uint32_t> faces;
  double area = 0;
};

// Coordinates are centred and scaled to about 1 before anything is squared, so that neither an offset of a
// million nor a size of 1e-30 costs precision or overflows.
struct Conditioning {
  Vec3 centre;
  double scale;
  Vec3 operator()(const Vec3& p) const { return (p - centre) / scale; }
};

Conditioning condition(const PolygonMesh& mesh) {
  Bounds box;
  if (mesh.is_point_set()) {
    box = bounds(mesh);
  } else {  // vertices that no face uses do not belong to the surface
    for (const auto c : mesh.face_corners) box.add(mesh.vertices[c]);
  }
  if (box.empty()) throw NumericError("the shape has no points");
  const Vec3 half = 0.5 * box.high - 0.5 * box.low;
  const double size = half.maxCoeff();
  if (!std::isfinite(size)) throw NumericError("the extent of the shape is not finite");
  if (!(size > 0)) throw NumericError("all points of the shape are at one place");
  return {0.5 * box.high + 0.5 * box.low, size};
}

Candidates sample_surface(const PolygonMesh& mesh, const Conditioning& conditioned, std::size_t count,
                          RandomStream random) {
  PolygonMesh scaled;
  scaled.face_corners = mesh.face_corners;
  scaled.face_begins = mesh.face_begins;
  scaled.vertices.reserve(mesh.vertices.size());
  for (const Vec3& v : mesh.vertices) scaled.vertices.push_back(conditioned(v));
  const Triangulation triangulation = triangulate(scaled);
  std::vector<double> cumulative;
  cumulative.reserve(triangulation.triangles.size());
  Candidates result;
  for (const auto& [a, b, c] : triangulation.triangles) {
    const Vec3 e1 = scaled.vertices[b] - scaled.vertices[a];
    const Vec3 e2 = scaled.vertices[c] - scaled.vertices[a];
    result.area += 0.5 * e1.cross(e2).norm();
    cumulative.push_back(result.area);
  }
  if (!(result.area > 0)) throw NumericError("no face of the shape has an area");
  // One sample per equal share of the area: less clumping to start from than independent draws.
  std::size_t t = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double at = result.area * (static_cast<double>(i) + random.uniform()) / static_cast<double>(count);
    while (t + 1 < cumulative.size() && cumulative[t] <= at) ++t;
    const auto& [a, b, c] = triangulation.triangles[t];
    double u = random.uniform();
    double v = random.uniform();
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    const Vec3 e1 = scaled.vertices[b] - scaled.vertices[a];
    const Vec3 e2 = scaled.vertices[c] - scaled.vertices[a];
    result.points.push_back(scaled.vertices[a] + u * e1 + v * e2);
    result.normals.push_back(e1.cross(e2).normalized());
    result.faces.push_back(triangulation.faces[t]);
  }
  return result;
}

// Normals of a point set that brings none: the direction of least spread among the nearest points.
std::vector<Vec3> estimate_normals(const std::vector<Vec3>& points) {
  constexpr std::size_t neighbours = 12;
  const KdTree tree(points);
  std::vector<KdTree::Neighbour> found;
  std::vector<Vec3> normals;
  normals.reserve(points.size());
  for (const Vec3& p : points) {
    tree.nearest(p, neighbours, found);
    Vec3 mean = Vec3::Zero();
    Mat3 moment = Mat3::Zero();
    for (const auto& f : found) {
      const Vec3 d = points[f.index] - p;
      mean += d;
      moment += d * d.transpose();
    }
    mean /= static_cast<double>(found.size());
    const Mat3 covariance = moment / static_cast<double>(found.size()) - mean * mean.transpose();
    Eigen::SelfAdjointEigenSolver<Mat3> solver;
    solver.computeDirect(covariance);
    normals.push_back(solver.eigenvectors().col(0));
  }
  return normals;
}

// The area that the points of a set stand for: pi r^2 / k for the disc of the k nearest, summed.
double estimate_area(const std::vector<Vec3>& points) {
  constexpr std::size_t neighbours = 8;
  const KdTree tree(points);
  std::vector<KdTree::Neighbour> found;
  double area = 0;
  for (const Vec3& p : points) {
    tree.nearest(p, neighbours, found);
    area += std::numbers::pi * found.back().squared_distance / static_cast<double>(found.size());
  }
  return area;
}

Candidates thin_point_set(const PolygonMesh& mesh, const Conditioning& conditioned, std::size_t count,
                          RandomStream random) {
  // Thinned at random first: elimination needs a few times as many points as it keeps, not millions.
  std::vector<std::uint32_t> chosen(mesh.vertices.size());
  std::iota(chosen.begin(), chosen.end(), 0U);
  const std::size_t wanted = std::min(chosen.size(), count);
  for (std::size_t i = 0; i < wanted; ++i) std::swap(chosen[i], chosen[i + random.below(chosen.size() - i)]);
  chosen.resize(wanted);
  std::sort(chosen.begin(), chosen.end());
  Candidates result;
  result.faces = chosen;
  for (const auto v : chosen) result.points.push_back(conditioned(mesh.vertices[v]));
  if (mesh.point_normals.size() == mesh.vertices.size()) {
    for (const auto v : chosen) result.normals.push_back(mesh.point_normals[v]);
  } else {
    result.normals = estimate_normals(result.points);
  }
  result.area = estimate_area(result.points);
  return result;
}

double largest_distance(const std::vector<Vec3>& points, const Vec3& centroid) {
  // Exact: pairs whose distances to the centroid add up to less than the best are never looked at.
  std::vector<std::pair<double, std::uint32_t>> order;
  for (std::size_t i = 0; i < points.size(); ++i) {
    order.emplace_back((points[i] - centroid).norm(), static_cast<std::uint32_t>(i));
  }
  std::sort(order.rbegin(), order.rend());
  double best = 0;
  for (std::size_t i = 0; i < order.size() && 2 * order[i].first > best; ++i) {
    for (std::size_t j = i + 1; j < order.size() && order[i].first + order[j].first > best; ++j) {
      best = std::max(best, (points[order[i].second] - points[order[j].second]).norm());
    }
  }
  return best;
}

}  // namespace

ShapeSamples sample_shape(const PolygonMesh& mesh, const ContentHash& hash, const SamplingOptions& options) {
  const Conditioning conditioned = condition(mesh);
  const RandomStream random(derive_seed(derive_seed(options.seed, hash.words[0]), hash.words[1]));
  const auto count = static_cast<std::size_t>(options.points);
  const Candidates candidates = mesh.is_point_set()
                                    ? thin_point_set(mesh, conditioned, oversampling * count, random)
                                    : sample_surface(mesh, conditioned, oversampling * count, random);
  const auto kept = eliminate_samples(candidates.points, count, std::max(candidates.area, 1e-12));

  ShapeSamples samples;
  const Mat3 rotation = upright_rotation(options.up);
  Vec3 centroid = Vec3::Zero();
  for (const auto i : kept) {
    samples.points.push_back(rotation * candidates.points[i]);
    samples.normals.push_back(rotation * candidates.normals[i]);
    samples.faces.push_back(candidates.faces[i]);
    centroid += samples.points.back();
  }
  centroid /= static_cast<double>(kept.size());
  double mean_distance = 0;
  for (const Vec3& p : samples.points) mean_distance += (p - centroid).norm();
  mean_distance /= static_cast<double>(kept.size());
  if (!(mean_distance > 0)) throw NumericError("all points of the shape are at one place");
  for (Vec3& p : samples.points) p = (p - centroid) / mean_distance;

  samples.frame.rotation = rotation;
  samples.frame.scale = 1.0 / (conditioned.scale * mean_distance);
  samples.frame.centroid = rotation * conditioned.centre + centroid * conditioned.scale;
  samples.radius = largest_distance(samples.points, Vec3::Zero());
  straighten(samples);
  auto features = compute_features(samples.points, feature_radius * samples.radius);
  samples.features_x = std::move(features.x);
  samples.features_z = std::move(features.z);
  return samples;
}

}  // namespace archetype
