// Labelling of a graph with Potts smoothness (Boykov, Veksler, Zabih 2001), for samples and for faces alike.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/fitting/max_flow.h"

namespace archetype {

// Neighbours of each node with the integer cost of giving the two different labels, each pair in both lists.
struct LabellingGraph {
  struct Neighbour {
    std::uint32_t node;
    std::int32_t weight;  // > 0
  };
  std::vector<std::uint32_t> begins{0};  // node_count() + 1
  std::vector<Neighbour> neighbours;

  std::size_t node_count() const { return begins.size() - 1; }
  std::span<const Neighbour> of(std::size_t node) const {
    return std::span(neighbours).subspan(begins[node], begins[node + 1] - begins[node]);
  }
};

// A pair of nodes that shall rather have the same label; a != b, a pair may come more than once (weights add
// up).
struct GraphEdge {
  std::uint32_t a;
  std::uint32_t b;
  std::int32_t weight;
};
LabellingGraph make_labelling_graph(std::size_t nodes, std::span<const GraphEdge> edges);

// unary: node_count x label_count, row by row, each cost in [0, 2^30]. Integers: cuts are exact and repeat.
using LabelCosts = std::vector<std::int32_t>;

// Buffers that one caller reuses from one labelling to the next.
struct ExpansionWorkspace {
  MaxFlow flow;
  std::vector<std::int32_t> variable;
  std::vector<std::uint32_t> nodes;
  std::vector<std::uint8_t> allowed;
  std::stop_token stop =
      {};  // once it asks, labelling ends early; the labels are those of the last whole move
};

struct ExpansionOptions {
  // Drops labels that cannot be part of a minimum: U_i(k) > min U_i + sum_j w_ij. Exact; off only to measure
  // its worth.
  bool prune = true;
};

// The energy: sum of unary costs and of the weights of neighbours with different labels.
std::int64_t labelling_energy(const LabellingGraph& graph, const LabelCosts& unary, std::size_t label_count,
                              std::span<const std::int16_t> labels);

// Improves `labels` (each in [0, label_count); a good start saves time) until no expansion move lowers the
// energy. Returns the energy, which is never above that of the start and within a factor of 2 of the best.
std::int64_t expand_labels(const LabellingGraph& graph, const LabelCosts& unary, std::size_t label_count,
                           std::span<std::int16_t> labels, ExpansionWorkspace& workspace,
                           const ExpansionOptions& options = {});

}  // namespace archetype
