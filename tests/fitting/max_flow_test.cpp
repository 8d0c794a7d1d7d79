#include "core/fitting/max_flow.h"

#include <doctest/doctest.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/push_relabel_max_flow.hpp>

#include "core/base/random.h"

using namespace archetype;

namespace {

struct RandomGraph {
  struct Edge {
    std::uint32_t a, b;
    std::int64_t forward, backward;
  };
  std::size_t nodes = 0;
  std::vector<std::array<std::int64_t, 2>> terminals;
  std::vector<Edge> edges;
};

RandomGraph make_graph(RandomStream& random) {
  RandomGraph graph;
  graph.nodes = 1 + random.below(40);
  const std::uint64_t range = 1 + random.below(20);
  for (std::size_t i = 0; i < graph.nodes; ++i) {
    graph.terminals.push_back(
        {static_cast<std::int64_t>(random.below(range)), static_cast<std::int64_t>(random.below(range))});
  }
  for (std::uint64_t e = random.below(4 * graph.nodes + 1); e > 0 && graph.nodes > 1; --e) {
    const auto a = static_cast<std::uint32_t>(random.below(graph.nodes));
    const auto b = static_cast<std::uint32_t>(random.below(graph.nodes));
    if (a == b) continue;
    graph.edges.push_back({a, b, static_cast<std::int64_t>(random.below(range)),
                           static_cast<std::int64_t>(random.below(range))});
  }
  return graph;
}

// Boost's push-relabel: neither the algorithm nor the code of ours.
std::int64_t oracle(const RandomGraph& graph) {
  using Traits = boost::adjacency_list_traits<boost::vecS, boost::vecS, boost::directedS>;
  using Graph = boost::adjacency_list<
      boost::vecS, boost::vecS, boost::directedS, boost::no_property,
      boost::property<boost::edge_capacity_t, std::int64_t,
                      boost::property<boost::edge_residual_capacity_t, std::int64_t,
                                      boost::property<boost::edge_reverse_t, Traits::edge_descriptor>>>>;
  Graph flow(graph.nodes + 2);
  const auto connect = [&](std::size_t a, std::size_t b, std::int64_t forward, std::int64_t backward) {
    const auto there = boost::add_edge(a, b, flow).first;
    const auto back = boost::add_edge(b, a, flow).first;
    boost::put(boost::edge_capacity, flow, there, forward);
    boost::put(boost::edge_capacity, flow, back, backward);
    boost::put(boost::edge_reverse, flow, there, back);
    boost::put(boost::edge_reverse, flow, back, there);
  };
  for (std::size_t i = 0; i < graph.nodes; ++i) {
    connect(graph.nodes, i, graph.terminals[i][0], 0);
    connect(i, graph.nodes + 1, graph.terminals[i][1], 0);
  }
  for (const auto& e : graph.edges) connect(e.a, e.b, e.forward, e.backward);
  return boost::push_relabel_max_flow(flow, graph.nodes, graph.nodes + 1);
}

}  // namespace

TEST_CASE("the flow is Boost's, and the cut that is found has its value") {
  RandomStream random(3);
  MaxFlow flow;  // reused: nothing may leak from one graph to the next
  for (int round = 0; round < 3000; ++round) {
    const RandomGraph graph = make_graph(random);
    flow.reset(graph.nodes);
    for (std::uint32_t i = 0; i < graph.nodes; ++i)
      flow.add_terminals(i, graph.terminals[i][0], graph.terminals[i][1]);
    for (const auto& e : graph.edges) flow.add_edge(e.a, e.b, e.forward, e.backward);
    const std::int64_t value = flow.solve();
    REQUIRE(value == oracle(graph));
    std::int64_t cut = 0;
    for (std::uint32_t i = 0; i < graph.nodes; ++i) cut += graph.terminals[i][flow.on_sink_side(i) ? 0 : 1];
    for (const auto& e : graph.edges) {
      if (!flow.on_sink_side(e.a) && flow.on_sink_side(e.b)) cut += e.forward;
      if (flow.on_sink_side(e.a) && !flow.on_sink_side(e.b)) cut += e.backward;
    }
    REQUIRE(cut == value);
  }
}

TEST_CASE("terminals may be given in several calls") {
  MaxFlow flow;
  flow.reset(1);
  flow.add_terminals(0, 5, 0);
  flow.add_terminals(0, 0, 3);
  flow.add_terminals(0, 1, 9);
  CHECK(flow.solve() == 6);
  CHECK(flow.on_sink_side(0));
}
