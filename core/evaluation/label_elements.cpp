// One cut with many labels over the faces, on the template's own cost at each face.
#include "core/evaluation/label_elements.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/fitting/label_costs.h"
#include "core/fitting/template_surface.h"
#include "core/geometry/face_adjacency.h"
#include "core/geometry/kd_tree.h"

namespace archetype {

namespace {

// Below this share of edges with exactly two faces a mesh is a soup, and a cut over it would be of no use.
constexpr double smallest_shared_share = 0.5;
// Parts meet in creases: a convex edge counts as hardly bent (Shapira et al. 2008).
constexpr double convex_angle_factor = 0.08;
constexpr double smallest_angle = 0.05;
// Costs are shares of the whole area in these units; a label costs at most `largest_cost` per area.
constexpr double cost_scale = 1 << 26;
constexpr double largest_cost = 15.0;

// Cost of each part (and of null, last) at each element: distance and features as for samples. Features are
// those of the nearest samples, by inverse distance.
class ElementCosts {
 public:
  ElementCosts(const ShapeSamples& samples, const PartTemplate& part_template, const ShapeFit& fit,
               const FitOptions& options)
      : samples_(samples),
        fit_(fit),
        options_(options),
        tree_(samples.points),
        features_(feature_costs(with_expected_features(part_template),
                                (fit.yaw_quarters & 1) != 0 ? samples.features_z : samples.features_x,
                                options)),
        unit_(options.distance_unit * samples.radius) {
    for (const FittedPart& part : fit.parts) boxes_.emplace_back(part.box);
  }

  void at(const Vec3& file_point, std::vector<double>& costs) {
    const Vec3 p = samples_.frame.to_normalised(file_point);
    const Vec3 q = fit_.to_template(p);
    constexpr std::size_t neighbours = 3;
    tree_.nearest(p, neighbours, near_);
    const std::size_t parts = boxes_.size();
    costs.assign(parts + 1, 0.0);
    double sum = 0;
    for (const auto& n : near_) {
      const double w = 1.0 / (n.squared_distance + 1e-8);
      sum += w;
      for (std::size_t k = 0; k < parts; ++k) costs[k] += w * features_[n.index * parts + k];
    }
    for (std::size_t k = 0; k < parts; ++k) {
      // Parts that the fit has no samples for are not there.
      costs[k] = fit_.parts[k].present
                     ? std::min(costs[k] / sum + boxes_[k].squared(q) / (unit_ * unit_), largest_cost)
                     : largest_cost;
    }
    costs[parts] = options_.null_cost;
  }

 private:
  const ShapeSamples& samples_;
  const ShapeFit& fit_;
  const FitOptions& options_;
  KdTree tree_;
  std::vector<double> features_;
  double unit_;
  std::vector<BoxDistance> boxes_;
  std::vector<KdTree::Neighbour> near_;
};

std::vector<std::int16_t> cut(const PolygonMesh& mesh, const FaceAdjacency& adjacency,
                              const ShapeSamples& samples, const PartTemplate& part_template,
                              const ShapeFit& fit, const FitOptions& options) {
  const std::size_t faces = mesh.face_count();
  const std::size_t count = fit.parts.size() + 1;
  std::vector<double> areas(faces);
  double area = 0;
  for (std::size_t f = 0; f < faces; ++f) area += areas[f] = 0.5 * face_area_vector(mesh, f).norm();
  ElementCosts element_costs(samples, part_template, fit, options);
  LabelCosts costs(faces * count);
  std::vector<std::int16_t> labels(faces);
  std::vector<double> row;
  for (std::size_t f = 0; f < faces; ++f) {
    element_costs.at(face_centre(mesh, f), row);
    labels[f] = static_cast<std::int16_t>(std::min_element(row.begin(), row.end()) - row.begin());
    const double share = cost_scale * areas[f] / area;
    for (std::size_t k = 0; k < count; ++k) {
      costs[f * count + k] = static_cast<std::int32_t>(std::lround(share * row[k]));
    }
  }
  // Edge lengths count in units of the root of the area, so that size does not matter.
  const double scale = options.face_smoothness * cost_scale / std::sqrt(area);
  std::vector<GraphEdge> edges;
  edges.reserve(adjacency.pairs.size());
  for (const FacePair& pair : adjacency.pairs) {
    const double theta = std::max(pair.angle * (pair.convex ? convex_angle_factor : 1.0), smallest_angle);
    // At least a little everywhere: no boundary is free.
    const double weight = -std::log(theta / std::numbers::pi) + 0.01;
    const auto w = static_cast<std::int32_t>(std::min(std::lround(scale * pair.length * weight), 1L << 28));
    if (w > 0) edges.push_back({pair.a, pair.b, w});
  }
  ExpansionWorkspace workspace;
  expand_labels(make_labelling_graph(faces, edges), costs, count, labels, workspace);
  return labels;
}

// Each element takes the label of most of its own samples, else of the nearest ones.
std::vector<std::int16_t> vote(const PolygonMesh& mesh, const ShapeSamples& samples, const ShapeFit& fit) {
  const std::size_t count = fit.parts.size() + 1;
  const auto null = static_cast<std::int16_t>(fit.parts.size());
  std::vector<std::vector<std::uint32_t>> own(mesh.element_count());
  for (std::uint32_t i = 0; i < samples.size(); ++i) {
    if (samples.faces[i] >= own.size())
      throw PreconditionError("label_elements: the samples belong to another mesh");
    own[samples.faces[i]].push_back(i);
  }
  const KdTree tree(samples.points);
  std::vector<KdTree::Neighbour> near;
  std::vector<std::int16_t> labels(mesh.element_count());
  std::vector<double> votes;
  for (std::size_t e = 0; e < labels.size(); ++e) {
    votes.assign(count, 0.0);
    const auto add = [&](std::uint32_t sample, double weight) {
      const auto label = fit.labels[sample];
      votes[static_cast<std::size_t>(label == null_label ? null : label)] += weight;
    };
    if (own[e].empty()) {
      const Vec3 p = mesh.is_point_set() ? mesh.vertices[e] : face_centre(mesh, e);
      tree.nearest(samples.frame.to_normalised(p), 3, near);
      for (const auto& n : near) add(n.index, 1.0 / (n.squared_distance + 1e-8));
    } else {
      for (const auto i : own[e]) add(i, 1.0);
    }
    labels[e] = static_cast<std::int16_t>(std::max_element(votes.begin(), votes.end()) - votes.begin());
  }
  return labels;
}

}  // namespace

std::vector<std::int16_t> label_elements(const PolygonMesh& mesh, const ShapeSamples& samples,
                                         const PartTemplate& part_template, const ShapeFit& fit,
                                         const FitOptions& options) {
  if (fit.parts.size() != part_template.parts.size() || fit.labels.size() != samples.size()) {
    throw PreconditionError("label_elements: the fit belongs to another template or shape");
  }
  const FaceAdjacency adjacency = find_adjacent_faces(mesh);
  auto labels = adjacency.shared_share >= smallest_shared_share
                    ? cut(mesh, adjacency, samples, part_template, fit, options)
                    : vote(mesh, samples, fit);
  std::replace(labels.begin(), labels.end(), static_cast<std::int16_t>(fit.parts.size()), null_label);
  return labels;
}

}  // namespace archetype
