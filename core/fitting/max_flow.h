// Minimum s-t cuts of small sparse graphs, the inner step of every labelling.
#pragma once

#include <cstdint>
#include <stop_token>
#include <vector>

namespace archetype {

// Maximum flow by augmenting paths between two search trees that are kept from one augmentation to the next
// (Boykov and Kolmogorov 2004, "An Experimental Comparison of Min-Cut/Max-Flow Algorithms", section 3).
// Capacities are integers, so cuts are exact and repeat. One object is reused for many graphs without
// allocating again.
class MaxFlow {
 public:
  using Capacity = std::int64_t;

  // Starts a graph of `nodes` nodes without edges.
  void reset(std::size_t nodes);
  // Adds capacities source -> node and node -> sink, each >= 0; may be called again for the same node.
  void add_terminals(std::uint32_t node, Capacity from_source, Capacity to_sink);
  // Adds capacities a -> b and b -> a, each >= 0.
  void add_edge(std::uint32_t a, std::uint32_t b, Capacity forward, Capacity backward);

  // The value of the minimum cut. May be called once per graph. Seconds for millions of nodes; what comes out
  // once `stop` asks to end early is worthless.
  Capacity solve(const std::stop_token& stop = {});
  // After solve(): whether the node lies on the sink's side of the minimum cut that is nearest to the sink.
  // Nodes that either side may have count as the source's.
  bool on_sink_side(std::uint32_t node) const { return nodes_[node].tree == Tree::sink; }

 private:
  enum class Tree : std::uint8_t { none, source, sink };
  static constexpr std::uint32_t no_arc = UINT32_MAX;
  static constexpr std::uint32_t terminal_arc = UINT32_MAX - 1;
  static constexpr std::uint32_t orphan_arc = UINT32_MAX - 2;

  struct Node {
    Capacity terminal = 0;  // residual: > 0 from the source, < 0 to the sink
    std::uint32_t first_arc = no_arc;
    std::uint32_t parent = no_arc;  // the arc towards the root
    std::uint32_t checked = 0;      // when `depth` was last known to be true
    std::uint32_t depth = 0;        // distance to the terminal along the tree
    Tree tree = Tree::none;
    bool active = false;
  };
  struct Arc {  // its reverse is arc ^ 1
    Capacity residual;
    std::uint32_t head;
    std::uint32_t next;
  };

  void activate(std::uint32_t node);
  std::uint32_t grow(std::uint32_t node);
  void augment(std::uint32_t bridge);
  void adopt();
  bool find_parent(std::uint32_t node);
  bool reaches_root(std::uint32_t node, std::uint32_t& depth);
  // The residual in the direction from the root of the tree to its leaves, over an arc that leaves a node of
  // the tree.
  Capacity outward(Tree tree, std::uint32_t arc) const {
    return tree == Tree::source ? arcs_[arc].residual : arcs_[arc ^ 1].residual;
  }

  std::vector<Node> nodes_;
  std::vector<Arc> arcs_;
  std::vector<std::uint32_t> active_;
  std::size_t next_active_ = 0;
  std::vector<std::uint32_t> orphans_;
  std::size_t next_orphan_ = 0;
  std::uint32_t time_ = 0;
  Capacity flow_ = 0;
};

}  // namespace archetype
