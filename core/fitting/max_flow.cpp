// Two search trees grow from the terminals; where they touch, a path is augmented, and nodes that lost their
// way to the root look for a new parent.
#include "core/fitting/max_flow.h"

#include <algorithm>

namespace archetype {

void MaxFlow::reset(std::size_t nodes) {
  nodes_.assign(nodes, Node{});
  arcs_.clear();
  active_.clear();
  orphans_.clear();
  next_active_ = 0;
  next_orphan_ = 0;
  time_ = 0;
  flow_ = 0;
}

void MaxFlow::add_terminals(std::uint32_t node, Capacity from_source, Capacity to_sink) {
  Capacity& residual = nodes_[node].terminal;
  if (residual > 0) {
    from_source += residual;
  } else {
    to_sink -= residual;
  }
  flow_ += std::min(from_source, to_sink);
  residual = from_source - to_sink;
}

void MaxFlow::add_edge(std::uint32_t a, std::uint32_t b, Capacity forward, Capacity backward) {
  const auto arc = static_cast<std::uint32_t>(arcs_.size());
  arcs_.push_back({forward, b, nodes_[a].first_arc});
  arcs_.push_back({backward, a, nodes_[b].first_arc});
  nodes_[a].first_arc = arc;
  nodes_[b].first_arc = arc + 1;
}

void MaxFlow::activate(std::uint32_t node) {
  if (nodes_[node].active) return;
  nodes_[node].active = true;
  active_.push_back(node);
}

MaxFlow::Capacity MaxFlow::solve(const std::stop_token& stop) {
  for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
    Node& node = nodes_[i];
    if (node.terminal == 0) continue;
    node.tree = node.terminal > 0 ? Tree::source : Tree::sink;
    node.parent = terminal_arc;
    node.depth = 1;
    activate(i);
  }
  constexpr std::uint32_t steps_between_looks = 4096;
  for (std::uint32_t step = 0; next_active_ < active_.size(); ++step) {
    if (step % steps_between_looks == 0 && stop.stop_requested()) break;
    const std::uint32_t node = active_[next_active_];
    if (nodes_[node].tree != Tree::none) {
      const std::uint32_t bridge = grow(node);
      if (bridge != no_arc) {  // the node stays first in the queue: it may touch the other tree elsewhere
        ++time_;
        augment(bridge);
        adopt();
        continue;
      }
    }
    nodes_[node].active = false;
    ++next_active_;
    if (next_active_ > 4096 && next_active_ * 2 > active_.size()) {
      active_.erase(active_.begin(), active_.begin() + static_cast<std::ptrdiff_t>(next_active_));
      next_active_ = 0;
    }
  }
  return flow_;
}

// Takes free neighbours into the tree. Returns an arc from the source's tree to the sink's with capacity
// left, if the node touches the other tree.
std::uint32_t MaxFlow::grow(std::uint32_t index) {
  const Tree tree = nodes_[index].tree;
  for (std::uint32_t arc = nodes_[index].first_arc; arc != no_arc; arc = arcs_[arc].next) {
    if (outward(tree, arc) == 0) continue;
    const std::uint32_t head = arcs_[arc].head;
    Node& other = nodes_[head];
    if (other.tree == Tree::none) {
      other.tree = tree;
      other.parent = arc ^ 1;
      other.checked = nodes_[index].checked;
      other.depth = nodes_[index].depth + 1;
      activate(head);
    } else if (other.tree != tree) {
      return tree == Tree::source ? arc : arc ^ 1;
    } else if (other.checked <= nodes_[index].checked && other.depth > nodes_[index].depth + 1) {
      // A shorter way to the root keeps augmenting paths short.
      other.parent = arc ^ 1;
      other.checked = nodes_[index].checked;
      other.depth = nodes_[index].depth + 1;
    }
  }
  return no_arc;
}

// Pushes as much as fits through root -> bridge -> root and cuts off what is saturated.
void MaxFlow::augment(std::uint32_t bridge) {
  const std::uint32_t source_end = arcs_[bridge ^ 1].head;
  const std::uint32_t sink_end = arcs_[bridge].head;
  Capacity bottleneck = arcs_[bridge].residual;
  std::uint32_t node = source_end;
  for (; nodes_[node].parent != terminal_arc; node = arcs_[nodes_[node].parent].head) {
    bottleneck = std::min(bottleneck, arcs_[nodes_[node].parent ^ 1].residual);
  }
  bottleneck = std::min(bottleneck, nodes_[node].terminal);
  for (node = sink_end; nodes_[node].parent != terminal_arc; node = arcs_[nodes_[node].parent].head) {
    bottleneck = std::min(bottleneck, arcs_[nodes_[node].parent].residual);
  }
  bottleneck = std::min(bottleneck, -nodes_[node].terminal);

  const auto orphan = [this](std::uint32_t i) {
    nodes_[i].parent = orphan_arc;
    orphans_.push_back(i);
  };
  arcs_[bridge].residual -= bottleneck;
  arcs_[bridge ^ 1].residual += bottleneck;
  for (node = source_end; nodes_[node].parent != terminal_arc;) {
    const std::uint32_t up = nodes_[node].parent;
    const std::uint32_t next = arcs_[up].head;
    arcs_[up].residual += bottleneck;
    arcs_[up ^ 1].residual -= bottleneck;
    if (arcs_[up ^ 1].residual == 0) orphan(node);
    node = next;
  }
  nodes_[node].terminal -= bottleneck;
  if (nodes_[node].terminal == 0) orphan(node);
  for (node = sink_end; nodes_[node].parent != terminal_arc;) {
    const std::uint32_t up = nodes_[node].parent;
    const std::uint32_t next = arcs_[up].head;
    arcs_[up].residual -= bottleneck;
    arcs_[up ^ 1].residual += bottleneck;
    if (arcs_[up].residual == 0) orphan(node);
    node = next;
  }
  nodes_[node].terminal += bottleneck;
  if (nodes_[node].terminal == 0) orphan(node);
  flow_ += bottleneck;
}

// Every orphan finds a parent in its own tree or leaves it, and its children become orphans.
void MaxFlow::adopt() {
  for (; next_orphan_ < orphans_.size(); ++next_orphan_) {
    const std::uint32_t index = orphans_[next_orphan_];
    if (find_parent(index)) continue;
    const Tree tree = nodes_[index].tree;
    for (std::uint32_t arc = nodes_[index].first_arc; arc != no_arc; arc = arcs_[arc].next) {
      const std::uint32_t head = arcs_[arc].head;
      Node& other = nodes_[head];
      if (other.tree != tree) continue;
      if (outward(tree, arc ^ 1) > 0) activate(head);  // it may grow back to here
      if (other.parent == (arc ^ 1)) {
        other.parent = orphan_arc;
        orphans_.push_back(head);
      }
    }
    nodes_[index].tree = Tree::none;
    nodes_[index].parent = no_arc;
  }
  orphans_.clear();
  next_orphan_ = 0;
}

bool MaxFlow::find_parent(std::uint32_t index) {
  Node& node = nodes_[index];
  std::uint32_t best = no_arc;
  std::uint32_t best_depth = UINT32_MAX;
  for (std::uint32_t arc = node.first_arc; arc != no_arc; arc = arcs_[arc].next) {
    const std::uint32_t head = arcs_[arc].head;
    if (nodes_[head].tree != node.tree || outward(node.tree, arc ^ 1) == 0) continue;
    std::uint32_t depth = 0;
    if (reaches_root(head, depth) && depth < best_depth) {
      best = arc;
      best_depth = depth;
    }
  }
  if (best == no_arc) return false;
  node.parent = best;
  node.checked = time_;
  node.depth = best_depth + 1;
  return true;
}

// Whether the way up from a node ends at a terminal and not at an orphan; marks the nodes on the way, so that
// the next question in this round is short.
bool MaxFlow::reaches_root(std::uint32_t index, std::uint32_t& depth) {
  std::uint32_t steps = 0;
  std::uint32_t node = index;
  for (;;) {
    if (nodes_[node].checked == time_ && time_ > 0) {
      depth = steps + nodes_[node].depth;
      break;
    }
    if (nodes_[node].parent == terminal_arc) {
      depth = steps + 1;
      nodes_[node].checked = time_;
      nodes_[node].depth = 1;
      break;
    }
    if (nodes_[node].parent == orphan_arc || nodes_[node].parent == no_arc) return false;
    ++steps;
    node = arcs_[nodes_[node].parent].head;
  }
  std::uint32_t remaining = depth;
  for (node = index; nodes_[node].checked != time_; node = arcs_[nodes_[node].parent].head) {
    nodes_[node].checked = time_;
    nodes_[node].depth = remaining--;
  }
  return true;
}

}  // namespace archetype
