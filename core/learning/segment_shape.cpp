// Farthest-point regions, fitted and joined.
#include "core/learning/segment_shape.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/fitting/fit_template.h"
#include "core/fitting/point_graph.h"
#include "core/geometry/kd_tree.h"
#include "core/learning/region_box.h"

namespace archetype {

namespace {

constexpr std::size_t seeds_per_part = 3;  // regions at the start for each part at most

using Labels = std::vector<std::int16_t>;

// The side of the square that each sample of an even set stands for.
double sample_spacing(const ShapeSamples& samples) {
  const KdTree tree(samples.points);
  std::vector<KdTree::Neighbour> nearest;
  double sum = 0;
  for (const Vec3& p : samples.points) {
    tree.nearest(p, 2, nearest);
    sum += std::sqrt(nearest.back().squared_distance);
  }
  // In blue noise the nearest neighbour is a little nearer than on a square grid.
  return std::max(1.15 * sum / static_cast<double>(samples.size()), 1e-3 * samples.radius);
}

// The Voronoi cells of `count` samples, each as far as can be from those before it.
Labels farthest_regions(const std::vector<Vec3>& points, std::size_t count, std::uint64_t seed) {
  Labels labels(points.size(), 0);
  std::vector<double> distance(points.size(), std::numeric_limits<double>::infinity());
  std::size_t next = RandomStream(seed).below(points.size());
  for (std::size_t k = 0; k < std::min(count, points.size()); ++k) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double d = (points[i] - points[next]).squaredNorm();
      if (d >= distance[i]) continue;
      distance[i] = d;
      labels[i] = static_cast<std::int16_t>(k);
    }
    next = static_cast<std::size_t>(std::ranges::max_element(distance) - distance.begin());
  }
  return labels;
}

// Regions and what joining any two that touch would cost.
class RegionTree {
 public:
  RegionTree(const ShapeSamples& samples, const LabellingGraph& graph, Labels labels, double unit,
             double spacing, RegionSolids solids, const JobControl& control)
      : samples_(samples),
        unit_(unit),
        spacing_(spacing),
        solids_(solids),
        control_(control),
        labels_(std::move(labels)) {
    regions_.resize(static_cast<std::size_t>(*std::ranges::max_element(labels_)) + 1);
    for (std::size_t i = 0; i < labels_.size(); ++i) regions_[region_of(i)].members.push_back(i);
    touching_.assign(regions_.size() * regions_.size(), false);
    for (std::size_t i = 0; i < labels_.size(); ++i) {
      for (const auto& n : graph.of(i)) touching_[region_of(i) * regions_.size() + region_of(n.node)] = true;
    }
    for (std::size_t r = 0; r < regions_.size(); ++r) {
      if (regions_[r].members.empty()) continue;
      regions_[r].fitted = fit(regions_[r].members);
      order_.push_back(r);
    }
    for (const std::size_t a : order_) {
      if (control_.cancelled()) return;
      for (const std::size_t b : order_) {
        if (a < b && touch(a, b)) joins_.push_back(join(a, b));
      }
    }
  }

  std::size_t count() const { return order_.size(); }
  double cost() const {
    double sum = 0;
    for (const std::size_t r : order_) sum += regions_[r].fitted.cost;
    return sum / static_cast<double>(samples_.size());
  }
  // Joins the two regions that it costs least to join; false if there is only one.
  bool join_cheapest() {
    if (joins_.empty()) join_all();
    if (joins_.empty()) return false;
    const Join best = *std::ranges::min_element(joins_, {}, &Join::rise);
    Region& kept = regions_[best.a];
    const Region& gone = regions_[best.b];
    kept.members.insert(kept.members.end(), gone.members.begin(), gone.members.end());
    kept.fitted = best.fitted;
    std::erase(order_, best.b);
    std::erase_if(joins_, [&](const Join& j) {
      return j.a == best.a || j.b == best.a || j.a == best.b || j.b == best.b;
    });
    for (const std::size_t r : order_) {
      if (r == best.a || !(touch(r, best.a) || touch(r, best.b))) continue;
      touching_[r * regions_.size() + best.a] = true;
      joins_.push_back(join(std::min(r, best.a), std::max(r, best.a)));
    }
    return true;
  }
  // The regions as they are now, the largest first.
  Segmentation segmentation() const {
    std::vector<std::size_t> order = order_;
    std::ranges::stable_sort(order, std::greater(),
                             [&](std::size_t r) { return regions_[r].members.size(); });
    Segmentation result;
    result.labels.resize(labels_.size());
    for (const std::size_t r : order) {
      for (const std::size_t i : regions_[r].members)
        result.labels[i] = static_cast<std::int16_t>(result.boxes.size());
      result.boxes.push_back(regions_[r].fitted.box);
    }
    return result;
  }

 private:
  struct Region {
    std::vector<std::size_t> members;  // samples
    RegionBox fitted;
  };
  struct Join {
    std::size_t a, b;
    RegionBox fitted;
    double rise;
  };

  std::size_t region_of(std::size_t sample) const { return static_cast<std::size_t>(labels_[sample]); }
  bool touch(std::size_t a, std::size_t b) const {
    return touching_[a * regions_.size() + b] || touching_[b * regions_.size() + a];
  }
  RegionBox fit(const std::vector<std::size_t>& members) const {
    std::vector<Vec3> points;
    points.reserve(members.size());
    for (const std::size_t i : members) points.push_back(samples_.points[i]);
    return fit_region_box(points, unit_, spacing_, solids_);
  }
  Join join(std::size_t a, std::size_t b) const {
    std::vector<std::size_t> members = regions_[a].members;
    members.insert(members.end(), regions_[b].members.begin(), regions_[b].members.end());
    Join join{a, b, fit(members), 0};
    join.rise = join.fitted.cost - regions_[a].fitted.cost - regions_[b].fitted.cost;
    return join;
  }
  // What does not touch may still be one part, as the rungs of a back are.
  void join_all() {
    for (const std::size_t a : order_) {
      if (control_.cancelled()) return;
      for (const std::size_t b : order_) {
        if (a < b) joins_.push_back(join(a, b));
      }
    }
  }

  const ShapeSamples& samples_;
  double unit_;
  double spacing_;
  RegionSolids solids_;
  const JobControl& control_;  // once cancelled, not all joins are there
  Labels labels_;
  std::vector<Region> regions_;
  std::vector<bool> touching_;      // regions x regions; either half may hold it
  std::vector<std::size_t> order_;  // of regions_, those that are left
  std::vector<Join> joins_;
};

// Lets the samples go to the boxes that fit them (section 4.1 with E_data + E_smooth alone).
std::optional<Labels> relabel(const ShapeSamples& samples, const Segmentation& segmentation,
                              const JobControl& control) {
  PartTemplate boxes;
  for (const Box& box : segmentation.boxes) {
    TemplatePart part;
    part.orientation = box.orientation;
    part.position = {box.centre, Vec3::Constant(samples.radius)};
    part.scale = {box.half_extent, Vec3::Constant(samples.radius)};
    part.has_features = true;
    part.existence = 0.5;
    boxes.parts.push_back(part);
  }
  FitOptions options;
  options.gamma = 0;
  options.turn_stddev = 0;  // the boxes stand as the parts do already
  options.max_alternations = 10;
  ShapeFit start;
  start.labels = segmentation.labels;
  const std::optional<ShapeFit> fit = refit_template(boxes, samples, start, options, control);
  if (!fit) return std::nullopt;
  // A sample that no box wants stays where it was.
  Labels labels = fit->labels;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] == null_label) labels[i] = segmentation.labels[i];
  }
  return labels;
}

}  // namespace

std::optional<Segmentation> segment_shape(const ShapeSamples& samples, const SegmentationOptions& options,
                                          const JobControl& control) {
  if (samples.size() == 0) throw PreconditionError("a shape without samples cannot be segmented");
  if (options.min_parts < 1 || options.max_parts < options.min_parts)
    throw PreconditionError("the number of parts has no range");
  const FitOptions fitting;
  const double unit = fitting.distance_unit * samples.radius;
  const double spacing = sample_spacing(samples);
  const LabellingGraph graph = make_point_graph(samples, fitting);
  const auto seeds = seeds_per_part * static_cast<std::size_t>(options.max_parts);
  Labels labels = farthest_regions(samples.points, seeds, options.seed);
  Segmentation best;
  Segmentation first;
  // Once from the cells, and once from what the parts found then have become.
  for (int round = 0; round < 2; ++round) {
    RegionTree tree(samples, graph, labels, unit, spacing, options.solids, control);
    best.cost = std::numeric_limits<double>::infinity();
    do {
      if (control.cancelled()) return std::nullopt;
      const auto parts = static_cast<double>(tree.count());
      if (parts > options.max_parts) continue;
      const double cost = tree.cost() + options.part_cost * parts;
      if (cost >= best.cost) continue;
      best = tree.segmentation();
      best.cost = cost;
    } while (static_cast<int>(tree.count()) > options.min_parts && tree.join_cheapest());
    if (round == 1) break;
    first = best;
    const std::optional<Labels> next = relabel(samples, best, control);
    if (!next) return std::nullopt;
    labels = *next;
  }
  // Letting the samples go may have left parts without any.
  if (static_cast<int>(best.boxes.size()) < options.min_parts) return first;
  return best;
}

}  // namespace archetype
