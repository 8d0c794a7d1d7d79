// Written for plainness; shares the energy and the small solves with the code that it checks, not the
// searches.
#include "tests/support/plain_fit.h"

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <limits>
#include <optional>

#include "core/fitting/choose_solids.h"
#include "core/fitting/deformation.h"
#include "core/fitting/energy.h"
#include "core/fitting/evidence.h"
#include "core/fitting/label_costs.h"
#include "core/fitting/point_graph.h"
#include "core/fitting/starting_boxes.h"
#include "core/fitting/template_surface.h"

namespace archetype::test {

namespace {

using Traits = boost::adjacency_list_traits<boost::vecS, boost::vecS, boost::directedS>;
using Graph = boost::adjacency_list<
    boost::vecS, boost::vecS, boost::directedS,
    boost::property<boost::vertex_index_t, std::size_t,
                    boost::property<boost::vertex_color_t, boost::default_color_type,
                                    boost::property<boost::vertex_distance_t, std::int64_t,
                                                    boost::property<boost::vertex_predecessor_t,
                                                                    Traits::edge_descriptor>>>>,
    boost::property<boost::edge_capacity_t, std::int64_t,
                    boost::property<boost::edge_residual_capacity_t, std::int64_t,
                                    boost::property<boost::edge_reverse_t, Traits::edge_descriptor>>>>;

void connect(Graph& graph, std::size_t a, std::size_t b, std::int64_t forward, std::int64_t backward) {
  const auto there = boost::add_edge(a, b, graph).first;
  const auto back = boost::add_edge(b, a, graph).first;
  boost::put(boost::edge_capacity, graph, there, forward);
  boost::put(boost::edge_capacity, graph, back, backward);
  boost::put(boost::edge_reverse, graph, there, back);
  boost::put(boost::edge_reverse, graph, back, there);
}

bool plain_move(const LabellingGraph& graph, const LabelCosts& unary, std::size_t label_count,
                std::span<std::int16_t> labels, std::int16_t alpha) {
  const std::size_t n = graph.node_count();
  const std::size_t source = n;
  const std::size_t sink = n + 1;
  Graph flow(n + 2);
  const std::int64_t before = labelling_energy(graph, unary, label_count, labels);
  for (std::size_t i = 0; i < n; ++i) {
    const auto cost = [&](std::int16_t label) {
      return static_cast<std::int64_t>(unary[i * label_count + static_cast<std::size_t>(label)]);
    };
    std::int64_t keep = labels[i] == alpha ? std::numeric_limits<std::int32_t>::max() : cost(labels[i]);
    for (const auto& neighbour : graph.of(i)) {
      if (neighbour.node < i) continue;
      if (labels[neighbour.node] == labels[i]) {
        connect(flow, i, neighbour.node, neighbour.weight, neighbour.weight);
      } else {
        keep += neighbour.weight;
        connect(flow, i, neighbour.node, 0, neighbour.weight);
      }
    }
    connect(flow, source, i, cost(alpha), 0);
    connect(flow, i, sink, keep, 0);
  }
  boost::boykov_kolmogorov_max_flow(flow, source, sink);
  std::vector<std::int16_t> moved(labels.begin(), labels.end());
  const auto colours = boost::get(boost::vertex_color, flow);
  const auto source_colour = colours[source];
  for (std::size_t i = 0; i < n; ++i) {
    if (colours[i] != source_colour) moved[i] = alpha;
  }
  if (labelling_energy(graph, unary, label_count, moved) >= before) return false;
  std::copy(moved.begin(), moved.end(), labels.begin());
  return true;
}

void plain_match(std::span<const Vec3> points, std::span<const std::int16_t> labels,
                 std::span<const Box> boxes, const TemplateSurface& surface, Correspondences& result) {
  result.on_template.resize(points.size());
  result.on_shape.assign(surface.local.size(), Correspondences::none);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (labels[i] != null_label) {
      result.on_template[i] = closest_on_surface(boxes[static_cast<std::size_t>(labels[i])], points[i]);
    }
  }
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    for (auto t = surface.begins[k]; t < surface.begins[k + 1]; ++t) {
      const Vec3 p = boxes[k].to_world(on_solid(boxes[k].solid, surface.local[t]));
      double best = std::numeric_limits<double>::infinity();
      for (std::uint32_t i = 0; i < points.size(); ++i) {
        if (labels[i] != static_cast<std::int16_t>(k)) continue;
        const double distance = (points[i] - p).squaredNorm();
        if (distance < best) {
          best = distance;
          result.on_shape[t] = i;
        }
      }
    }
  }
}

}  // namespace

std::int64_t plain_expand_labels(const LabellingGraph& graph, const LabelCosts& unary,
                                 std::size_t label_count, std::span<std::int16_t> labels) {
  for (bool moved = true; moved;) {
    moved = false;
    for (std::size_t k = 0; k < label_count; ++k) {
      moved |= plain_move(graph, unary, label_count, labels, static_cast<std::int16_t>(k));
    }
  }
  return labelling_energy(graph, unary, label_count, labels);
}

namespace {

// What stays the same over yaws and alternations.
struct Plain {
  const PartTemplate& part_template;
  const ShapeSamples& samples;
  const FitOptions& options;
  TemplateSurface surface;
  LabellingGraph graph;
  double unit;
};

struct Step {
  std::vector<Vec3> points;
  std::vector<double> features;
  LabelCosts costs;
};

// Points and costs for boxes over the shape as it stands in `fit`; dropped parts cost too much for any
// sample.
Step make_step(const Plain& plain, const ShapeFit& fit, std::span<const Box> boxes,
               const std::vector<bool>& dropped) {
  Step step;
  const int yaw = fit.yaw_quarters;
  step.features =
      feature_costs(plain.part_template, (yaw & 1) != 0 ? plain.samples.features_z : plain.samples.features_x,
                    plain.options);
  for (const Vec3& p : plain.samples.points) step.points.push_back(turn_quarters(p, -yaw) - fit.translation);
  label_costs(step.points, boxes, step.features, plain.unit, plain.options, step.costs);
  for (std::size_t i = 0; i < step.points.size(); ++i) {
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      if (dropped[k]) step.costs[i * (boxes.size() + 1) + k] = 1 << 30;
    }
  }
  return step;
}

// The alternation from the given boxes at the yaw and translation of `start`; `start` itself if it has to
// gain and its first step does not.
ShapeFit alternate(const Plain& plain, const ShapeFit& start, std::vector<Box> boxes,
                   const std::vector<bool>& dropped, bool has_to_gain = false) {
  const std::size_t count = boxes.size() + 1;
  ShapeFit fit = start;
  if (!has_to_gain) fit.energy.existence = std::numeric_limits<double>::infinity();
  ShapeFit next = start;
  for (int step = 0; step < plain.options.max_alternations; ++step) {
    Step at = make_step(plain, next, boxes, dropped);
    next.labels.clear();
    for (std::size_t i = 0; i < at.points.size(); ++i) {
      const auto row = at.costs.begin() + static_cast<std::ptrdiff_t>(i * count);
      next.labels.push_back(
          static_cast<std::int16_t>(std::min_element(row, row + static_cast<std::ptrdiff_t>(count)) - row));
    }
    plain_expand_labels(plain.graph, at.costs, count, next.labels);
    std::replace(next.labels.begin(), next.labels.end(), static_cast<std::int16_t>(count - 1), null_label);
    Correspondences matches;
    plain_match(at.points, next.labels, boxes, plain.surface, matches);
    const MatchedShape shape{at.points, next.labels, &plain.surface, &matches, plain.unit};
    next.energy = fit_energy(shape, plain.part_template, boxes, at.features, plain.graph, plain.options);
    if (next.energy.total() >= fit.energy.total()) break;
    const bool same = next.labels == fit.labels;
    next.alternations = step + 1;
    next.parts.clear();
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      const bool present = std::ranges::count(next.labels, static_cast<std::int16_t>(k)) > 0;
      next.parts.push_back({present, present ? boxes[k] : plain.part_template.parts[k].mean_box()});
    }
    fit = next;
    if (same) break;
    const Vec3 move = rigid_step(shape, boxes);
    next.translation -= move;
    for (Vec3& p : at.points) p += move;
    deformation_step(shape, plain.part_template, plain.options, boxes);
  }
  return fit;
}

// The boxes of a fit with round solids where they are better; nothing if there are none.
std::optional<std::vector<Box>> rounded(const Plain& plain, const ShapeFit& fit) {
  const std::vector<Box> boxes = fit.boxes();
  const Step at = make_step(plain, fit, boxes, std::vector<bool>(boxes.size(), false));
  const auto match = [&](std::span<const Box> tried, Correspondences& matches) {
    plain_match(at.points, fit.labels, tried, plain.surface, matches);
  };
  Correspondences matches;
  match(boxes, matches);
  return choose_solids({at.points, fit.labels, &plain.surface, &matches, plain.unit}, plain.part_template,
                       boxes, plain.options, match);
}

// The part with the least evidence, if that is below zero.
std::optional<std::size_t> unfounded_part(const Plain& plain, const ShapeFit& fit, std::span<const Box> boxes,
                                          const std::vector<bool>& dropped) {
  const Step at = make_step(plain, fit, boxes, dropped);
  Correspondences matches;
  plain_match(at.points, fit.labels, boxes, plain.surface, matches);
  const auto evidence = part_evidence({at.points, fit.labels, &plain.surface, &matches, plain.unit},
                                      plain.part_template, boxes, at.costs, plain.options);
  const auto least = std::min_element(evidence.begin(), evidence.end());
  if (*least >= 0) return std::nullopt;
  return static_cast<std::size_t>(least - evidence.begin());
}

// With what is round, and then without what the shape gives no evidence for.
ShapeFit finished(const Plain& plain, ShapeFit best) {
  const std::vector<Box> means = mean_boxes(plain.part_template);
  std::vector<bool> dropped(means.size(), false);
  if (const auto boxes = rounded(plain, best)) best = alternate(plain, best, *boxes, dropped, true);
  while (plain.options.drop_parts) {
    std::vector<Box> boxes = best.boxes();
    const auto part = unfounded_part(plain, best, boxes, dropped);
    if (!part) break;
    dropped[*part] = true;
    boxes[*part] = means[*part];
    best = alternate(plain, best, boxes, dropped);
  }
  return best;
}

}  // namespace

ShapeFit plain_fit(const PartTemplate& given, const ShapeSamples& samples, const FitOptions& options) {
  const PartTemplate part_template = with_expected_features(given);
  const Plain plain{part_template,
                    samples,
                    options,
                    sample_template(part_template, options.template_points),
                    make_point_graph(samples, options),
                    options.distance_unit * samples.radius};
  const std::vector<Box> means = mean_boxes(part_template);
  const std::vector<bool> dropped(means.size(), false);
  ShapeFit best;
  double least = std::numeric_limits<double>::infinity();
  for (int yaw = 0; yaw < 4; ++yaw) {
    ShapeFit start;
    start.yaw_quarters = yaw;
    std::vector<Vec3> turned;
    for (const Vec3& p : samples.points) turned.push_back(turn_quarters(p, -yaw));
    const ShapeFit mean = alternate(plain, start, means, dropped);
    const ShapeFit stretched = alternate(plain, start, stretched_boxes(part_template, turned), dropped);
    if (std::min(mean.energy.total(), stretched.energy.total()) >= least) continue;
    least = std::min(mean.energy.total(), stretched.energy.total());
    best = stretched.energy.total() * stretch_handicap < mean.energy.total() ? stretched : mean;
  }
  best = finished(plain, best);
  ShapeFit start;
  start.yaw_quarters = best.yaw_quarters;
  start.translation = best.translation;
  const ShapeFit again =
      finished(plain, alternate(plain, start, carried_boxes(part_template, best.parts), dropped));
  return again.energy.total() < best.energy.total() ? again : best;
}

}  // namespace archetype::test
