// One cut with many labels over the faces, on the template's own cost at each face.
#include "core/evaluation/label_elements.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/error.h"
#include "core/fitting/label_costs.h"
#include "core/fitting/point_graph.h"
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
constexpr double smallest_across = 1e-3;  // of the reach: slivers bend by rounding alone
// Costs are shares of the whole area in these units; a label costs at most `largest_cost` per area.
constexpr double cost_scale = 1 << 25;
constexpr double largest_cost = 15.0;
// Above every sum of a face's other costs, so that pruning drops the label before any cut.
constexpr std::int32_t forbidden_cost = 1 << 30;
constexpr std::size_t elements_between_looks = 4096;  // at whether it is cancelled

// The samples in the core of each connected piece of one label: those at least `share` as many steps from
// another label as the deepest sample of the piece. Their labels are certain; boundaries may move outside the
// cores only, so that smoothness can never swallow a small part (the fuzzy regions of Katz and Tal 2003, in
// proportion to the part).
std::vector<bool> core_samples(const LabellingGraph& graph, std::span<const std::int16_t> labels,
                               double share) {
  const std::size_t n = labels.size();
  constexpr std::uint32_t unseen = UINT32_MAX;
  std::vector<std::uint32_t> depth(n, unseen);
  std::vector<std::uint32_t> queue;
  const auto spread = [&](std::vector<std::uint32_t>& value, std::uint32_t step) {
    for (std::size_t at = 0; at < queue.size(); ++at) {
      for (const auto& neighbour : graph.of(queue[at])) {
        if (value[neighbour.node] != unseen || labels[neighbour.node] != labels[queue[at]]) continue;
        value[neighbour.node] = value[queue[at]] + step;
        queue.push_back(neighbour.node);
      }
    }
  };
  for (std::uint32_t i = 0; i < n; ++i) {
    const auto around = graph.of(i);
    const bool boundary =
        std::any_of(around.begin(), around.end(), [&](const auto& x) { return labels[x.node] != labels[i]; });
    if (boundary) {
      depth[i] = 0;
      queue.push_back(i);
    }
  }
  spread(depth, 1);
  std::vector<std::uint32_t> piece(n, unseen);
  std::vector<std::uint32_t> deepest;
  for (std::uint32_t i = 0; i < n; ++i) {
    if (piece[i] != unseen) continue;
    piece[i] = static_cast<std::uint32_t>(deepest.size());
    queue.assign(1, i);
    spread(piece, 0);
    deepest.push_back(0);
    for (const auto j : queue) deepest.back() = std::max(deepest.back(), depth[j] == unseen ? 0 : depth[j]);
  }
  std::vector<bool> core(n);
  for (std::size_t i = 0; i < n; ++i) core[i] = depth[i] == unseen || depth[i] >= share * deepest[piece[i]];
  return core;
}

// The cost of a boundary between two faces: its length in units of the root of the area, dear where the
// surface runs on and cheap in creases.
LabellingGraph make_face_graph(const FaceAdjacency& adjacency, std::size_t faces, double area,
                               const FitOptions& options) {
  const double scale = options.face_smoothness * cost_scale / std::sqrt(area);
  const double reach = options.crease_reach * std::sqrt(area);
  std::vector<GraphEdge> edges;
  edges.reserve(adjacency.pairs.size());
  for (const FacePair& pair : adjacency.pairs) {
    // A rounded crease is bent a little at each of many edges: what counts is how much the surface bends over
    // a fixed length, so that fine meshes have creases as coarse ones do.
    const double edges_in_reach = reach / std::max(pair.across, smallest_across * reach);
    const double bend = std::min(pair.angle * std::max(1.0, edges_in_reach), std::numbers::pi);
    const double theta = std::max(bend * (pair.convex ? convex_angle_factor : 1.0), smallest_angle);
    // At least a little everywhere: no boundary is free.
    const double weight = -std::log(theta / std::numbers::pi) + 0.01;
    const auto w = static_cast<std::int32_t>(std::min(std::lround(scale * pair.length * weight), 1L << 26));
    if (w > 0) edges.push_back({pair.a, pair.b, w});
  }
  return make_labelling_graph(faces, edges);
}

}  // namespace

ElementLabeller::ElementLabeller(const PolygonMesh& mesh, const ShapeSamples& samples,
                                 const FitOptions& options, const JobControl& control)
    : samples_(&samples), options_(options), elements_(mesh.element_count()) {
  if (samples.size() == 0) throw PreconditionError("a shape without samples cannot be labelled");
  for (const auto f : samples.faces) {
    if (f >= elements_.size()) throw PreconditionError("the samples to label from belong to another mesh");
  }
  const KdTree tree(samples.points);
  std::vector<KdTree::Neighbour> near;
  double area = 0;
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    if (e % elements_between_looks == 0 && control.cancelled()) return;
    Element& element = elements_[e];
    element.point =
        samples.frame.to_normalised(mesh.is_point_set() ? mesh.vertices[e] : face_centre(mesh, e));
    element.area_share = mesh.is_point_set() ? 1.0 : 0.5 * face_area_vector(mesh, e).norm();
    area += element.area_share;
    tree.nearest(element.point, nearest_count, near);
    double sum = 0;
    for (std::size_t i = 0; i < near.size(); ++i) {
      element.nearest[i] = near[i].index;
      sum += element.weights[i] = 1.0 / (near[i].squared_distance + 1e-8);
    }
    for (double& w : element.weights) w /= sum;
  }
  if (area > 0) {
    for (Element& element : elements_) element.area_share /= area;
  }
  const FaceAdjacency adjacency = find_adjacent_faces(mesh);
  surface_ = adjacency.shared_share >= smallest_shared_share && area > 0;
  if (!surface_ || control.cancelled()) return;
  faces_ = make_face_graph(adjacency, elements_.size(), area, options);
  points_ = make_point_graph(samples, options);
  around_.reserve(samples.size());
  for (const Vec3& point : samples.points) {
    tree.nearest(point, static_cast<std::size_t>(options.face_neighbours), near);
    auto& around = around_.emplace_back();
    for (const auto& neighbour : near) around.push_back(neighbour.index);
  }
}

std::vector<std::int16_t> ElementLabeller::label(const PartTemplate& part_template, const ShapeFit& fit,
                                                 const JobControl& control,
                                                 std::span<const PinnedLabel> pinned) const {
  if (fit.parts.size() != part_template.parts.size() || fit.labels.size() != samples_->size()) {
    throw PreconditionError("the fit to label with belongs to another template or shape");
  }
  auto labels = surface_ ? cut(part_template, fit, control, pinned) : vote(fit, pinned);
  if (control.cancelled()) return {};
  std::replace(labels.begin(), labels.end(), static_cast<std::int16_t>(fit.parts.size()), null_label);
  return labels;
}

// The cost of a part at a face is what it is for samples: the distance of the face's centre, and the features
// of the samples next to it. A face may take the labels of the samples around the one nearest to it, and only
// that one's label if it lies in the core of its part.
std::vector<std::int16_t> ElementLabeller::cut(const PartTemplate& part_template, const ShapeFit& fit,
                                               const JobControl& control,
                                               std::span<const PinnedLabel> pinned) const {
  const std::size_t parts = fit.parts.size();
  const std::size_t count = parts + 1;
  const auto null = static_cast<std::int16_t>(parts);
  const bool odd = (fit.yaw_quarters & 1) != 0;
  const auto features = feature_costs(with_expected_features(part_template),
                                      odd ? samples_->features_z : samples_->features_x, options_);
  const double unit = options_.distance_unit * samples_->radius;
  std::vector<BoxDistance> boxes;
  for (const FittedPart& part : fit.parts) boxes.emplace_back(part.box);

  auto core = core_samples(points_, fit.labels, options_.face_core);
  for (const PinnedLabel& pin : pinned) core[pin.sample] = true;
  std::vector<std::vector<std::int16_t>> candidates(samples_->size());
  const auto add_candidate = [&](std::size_t i, std::uint32_t sample) {
    const auto label = fit.labels[sample];
    candidates[i].push_back(label == null_label ? null : label);
  };
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (core[i])
      add_candidate(i, static_cast<std::uint32_t>(i));
    else
      for (const std::uint32_t sample : around_[i]) add_candidate(i, sample);
    std::sort(candidates[i].begin(), candidates[i].end());
    candidates[i].erase(std::unique(candidates[i].begin(), candidates[i].end()), candidates[i].end());
  }

  LabelCosts costs(elements_.size() * count);
  std::vector<std::int16_t> labels(elements_.size());
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    if (e % elements_between_looks == 0 && control.cancelled()) return {};
    const Element& element = elements_[e];
    const double share = cost_scale * element.area_share;
    const auto row = std::span(costs).subspan(e * count, count);
    std::fill(row.begin(), row.end(), forbidden_cost);
    const Vec3 q = fit.to_template(element.point);
    double best = std::numeric_limits<double>::infinity();
    labels[e] = candidates[element.nearest[0]].front();
    for (const auto label : candidates[element.nearest[0]]) {
      const auto k = static_cast<std::size_t>(label);
      double cost = options_.null_cost;
      if (label != null) {
        cost = boxes[k].squared(q) / (unit * unit);
        for (std::size_t n = 0; n < nearest_count; ++n) {
          cost += element.weights[n] * features[element.nearest[n] * parts + k];
        }
      }
      cost = std::min(cost, largest_cost);
      row[k] = static_cast<std::int32_t>(std::lround(share * cost));
      if (cost < best) {
        best = cost;
        labels[e] = label;
      }
    }
  }
  ExpansionWorkspace workspace;
  workspace.stop = control.stop;
  expand_labels(faces_, costs, count, labels, workspace);
  return labels;
}

// Each element takes the label of most of its own samples, else of the nearest ones.
std::vector<std::int16_t> ElementLabeller::vote(const ShapeFit& fit,
                                                std::span<const PinnedLabel> pinned) const {
  const std::size_t count = fit.parts.size() + 1;
  const auto null = static_cast<std::int16_t>(fit.parts.size());
  const auto label_of = [&](std::uint32_t sample) {
    return static_cast<std::size_t>(fit.labels[sample] == null_label ? null : fit.labels[sample]);
  };
  std::vector<std::uint32_t> own(elements_.size() * count, 0);
  for (std::uint32_t i = 0; i < samples_->size(); ++i) ++own[samples_->faces[i] * count + label_of(i)];
  // More than all others together.
  const auto decides = static_cast<std::uint32_t>(samples_->size());
  for (const PinnedLabel& pin : pinned)
    own[samples_->faces[pin.sample] * count + label_of(pin.sample)] += decides;
  std::vector<std::int16_t> labels(elements_.size());
  std::vector<double> votes;
  for (std::size_t e = 0; e < labels.size(); ++e) {
    const auto row = own.begin() + static_cast<std::ptrdiff_t>(e * count);
    votes.assign(row, row + static_cast<std::ptrdiff_t>(count));
    if (*std::max_element(votes.begin(), votes.end()) == 0) {
      for (std::size_t n = 0; n < nearest_count; ++n) {
        votes[label_of(elements_[e].nearest[n])] += elements_[e].weights[n];
      }
    }
    labels[e] = static_cast<std::int16_t>(std::max_element(votes.begin(), votes.end()) - votes.begin());
  }
  return labels;
}

std::vector<float> ElementLabeller::interpolate(const std::vector<double>& values) const {
  std::vector<float> result;
  result.reserve(elements_.size());
  for (const Element& element : elements_) {
    double sum = 0;
    for (std::size_t k = 0; k < nearest_count; ++k) sum += element.weights[k] * values[element.nearest[k]];
    result.push_back(static_cast<float>(sum));
  }
  return result;
}

std::vector<std::int16_t> label_elements(const PolygonMesh& mesh, const ShapeSamples& samples,
                                         const PartTemplate& part_template, const ShapeFit& fit,
                                         const FitOptions& options, const JobControl& control,
                                         std::span<const PinnedLabel> pinned) {
  const ElementLabeller labeller(mesh, samples, options, control);
  if (control.cancelled()) return {};
  return labeller.label(part_template, fit, control, pinned);
}

}  // namespace archetype
