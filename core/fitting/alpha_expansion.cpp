// One cut for each expansion move, over the nodes that can take the label at all.
#include "core/fitting/alpha_expansion.h"

#include <algorithm>

namespace archetype {

LabellingGraph make_labelling_graph(std::size_t nodes, std::span<const GraphEdge> edges) {
  LabellingGraph graph;
  graph.begins.assign(nodes + 1, 0);
  for (const GraphEdge& e : edges) {
    ++graph.begins[e.a + 1];
    ++graph.begins[e.b + 1];
  }
  for (std::size_t i = 0; i < nodes; ++i) graph.begins[i + 1] += graph.begins[i];
  graph.neighbours.resize(2 * edges.size());
  std::vector<std::uint32_t> at(graph.begins.begin(), graph.begins.end() - 1);
  for (const GraphEdge& e : edges) {
    graph.neighbours[at[e.a]++] = {e.b, e.weight};
    graph.neighbours[at[e.b]++] = {e.a, e.weight};
  }
  return graph;
}

std::int64_t labelling_energy(const LabellingGraph& graph, const LabelCosts& unary, std::size_t label_count,
                              std::span<const std::int16_t> labels) {
  std::int64_t energy = 0;
  std::int64_t twice_smooth = 0;
  for (std::size_t i = 0; i < graph.node_count(); ++i) {
    energy += unary[i * label_count + static_cast<std::size_t>(labels[i])];
    for (const auto& n : graph.of(i)) twice_smooth += labels[n.node] != labels[i] ? n.weight : 0;
  }
  return energy + twice_smooth / 2;
}

namespace {

void find_allowed(const LabellingGraph& graph, const LabelCosts& unary, std::size_t label_count, bool prune,
                  std::vector<std::uint8_t>& allowed) {
  allowed.assign(unary.size(), 1);
  if (!prune) return;
  for (std::size_t i = 0; i < graph.node_count(); ++i) {
    const auto row = std::span(unary).subspan(i * label_count, label_count);
    std::int64_t bound = *std::min_element(row.begin(), row.end());
    for (const auto& n : graph.of(i)) bound += n.weight;
    for (std::size_t k = 0; k < label_count; ++k) allowed[i * label_count + k] = row[k] <= bound ? 1 : 0;
  }
}

// The move to label alpha: the sink's side takes it. The constant part of the energy is left out; the change
// of energy is the cut's value less that of changing nothing, which is what `keep` sums up.
bool expand(const LabellingGraph& graph, const LabelCosts& unary, std::size_t label_count,
            std::span<std::int16_t> labels, std::int16_t alpha, ExpansionWorkspace& work) {
  work.nodes.clear();
  work.variable.assign(graph.node_count(), -1);
  for (std::size_t i = 0; i < graph.node_count(); ++i) {
    if (labels[i] == alpha || work.allowed[i * label_count + static_cast<std::size_t>(alpha)] == 0) continue;
    work.variable[i] = static_cast<std::int32_t>(work.nodes.size());
    work.nodes.push_back(static_cast<std::uint32_t>(i));
  }
  if (work.nodes.empty()) return false;
  work.flow.reset(work.nodes.size());
  std::int64_t keep = 0;
  for (std::uint32_t v = 0; v < work.nodes.size(); ++v) {
    const std::uint32_t i = work.nodes[v];
    // A node on the source's side keeps its label, and then pays on its edge to the sink.
    std::int64_t keep_cost = unary[i * label_count + static_cast<std::size_t>(labels[i])];
    std::int64_t take_cost = unary[i * label_count + static_cast<std::size_t>(alpha)];
    for (const auto& n : graph.of(i)) {
      const bool differ = labels[n.node] != labels[i];
      if (work.variable[n.node] < 0) {
        if (differ) keep_cost += n.weight;
        if (labels[n.node] != alpha) take_cost += n.weight;
      } else if (n.node > i) {
        const auto u = static_cast<std::uint32_t>(work.variable[n.node]);
        if (differ) {  // w (1 - x_i) + w x_i (1 - x_j), with x = 1 for those that take alpha
          keep_cost += n.weight;
          work.flow.add_edge(v, u, 0, n.weight);
        } else {
          work.flow.add_edge(v, u, n.weight, n.weight);
        }
      }
    }
    keep += keep_cost;
    work.flow.add_terminals(v, take_cost, keep_cost);
  }
  if (work.flow.solve(work.stop) >= keep || work.stop.stop_requested()) return false;
  for (std::uint32_t v = 0; v < work.nodes.size(); ++v) {
    if (work.flow.on_sink_side(v)) labels[work.nodes[v]] = alpha;
  }
  return true;
}

}  // namespace

std::int64_t expand_labels(const LabellingGraph& graph, const LabelCosts& unary, std::size_t label_count,
                           std::span<std::int16_t> labels, ExpansionWorkspace& workspace,
                           const ExpansionOptions& options) {
  find_allowed(graph, unary, label_count, options.prune, workspace.allowed);
  // Done when every label in turn has found nothing to gain.
  std::size_t idle = 0;
  for (std::size_t k = 0; idle < label_count && !workspace.stop.stop_requested(); k = (k + 1) % label_count) {
    const bool moved = expand(graph, unary, label_count, labels, static_cast<std::int16_t>(k), workspace);
    idle = moved ? 1 : idle + 1;
  }
  return labelling_energy(graph, unary, label_count, labels);
}

}  // namespace archetype
