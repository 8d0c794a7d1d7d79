#include "core/fitting/alpha_expansion.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "core/base/random.h"
#include "tests/support/plain_fit.h"

using namespace archetype;

namespace {

struct Problem {
  LabellingGraph graph;
  LabelCosts unary;
  std::size_t label_count;
};

Problem make_problem(RandomStream& random, std::size_t nodes, std::size_t label_count, std::uint64_t weight) {
  std::vector<GraphEdge> edges;
  for (std::uint64_t e = random.below(3 * nodes); e > 0; --e) {
    const auto a = static_cast<std::uint32_t>(random.below(nodes));
    const auto b = static_cast<std::uint32_t>(random.below(nodes));
    if (a != b) edges.push_back({a, b, static_cast<std::int32_t>(1 + random.below(weight))});
  }
  Problem problem{make_labelling_graph(nodes, edges), {}, label_count};
  for (std::size_t i = 0; i < nodes * label_count; ++i)
    problem.unary.push_back(static_cast<std::int32_t>(random.below(100)));
  return problem;
}

std::int64_t best_energy(const Problem& problem) {
  std::vector<std::int16_t> labels(problem.graph.node_count(), 0);
  std::int64_t best = INT64_MAX;
  for (;;) {
    best = std::min(best, labelling_energy(problem.graph, problem.unary, problem.label_count, labels));
    std::size_t i = 0;
    while (i < labels.size() && ++labels[i] == static_cast<std::int16_t>(problem.label_count))
      labels[i++] = 0;
    if (i == labels.size()) return best;
  }
}

}  // namespace

TEST_CASE("two labels give the exact minimum, more are within the factor that is proven") {
  RandomStream random(5);
  ExpansionWorkspace workspace;
  for (int round = 0; round < 300; ++round) {
    const std::size_t label_count = 2 + random.below(3);
    const Problem problem = make_problem(random, 2 + random.below(6), label_count, 80);
    const std::int64_t best = best_energy(problem);
    for (const bool prune : {true, false}) {
      std::vector<std::int16_t> labels(problem.graph.node_count(), 0);
      const std::int64_t energy =
          expand_labels(problem.graph, problem.unary, label_count, labels, workspace, {.prune = prune});
      REQUIRE(energy == labelling_energy(problem.graph, problem.unary, label_count, labels));
      REQUIRE(energy <= 2 * best);
      if (label_count == 2) REQUIRE(energy == best);
    }
  }
}

TEST_CASE("it ends where Boost's cuts end, and never above its start") {
  RandomStream random(6);
  ExpansionWorkspace workspace;
  std::int64_t ours = 0;
  std::int64_t plain = 0;
  for (int round = 0; round < 60; ++round) {
    const Problem problem = make_problem(random, 50, 5, 40);
    std::vector<std::int16_t> start(50);
    for (auto& l : start) l = static_cast<std::int16_t>(random.below(5));
    const std::int64_t before = labelling_energy(problem.graph, problem.unary, 5, start);
    auto a = start;
    auto b = start;
    const std::int64_t energy =
        expand_labels(problem.graph, problem.unary, 5, a, workspace, {.prune = false});
    REQUIRE(energy <= before);
    ours += energy;
    plain += test::plain_expand_labels(problem.graph, problem.unary, 5, b);
    // No single expansion gains any more: Boost's must find nothing to do either.
    auto c = a;
    REQUIRE(test::plain_expand_labels(problem.graph, problem.unary, 5, c) == energy);
  }
  CHECK(static_cast<double>(ours) == doctest::Approx(static_cast<double>(plain)).epsilon(0.002));
}

TEST_CASE("pruned labels are never part of a minimum") {
  RandomStream random(7);
  ExpansionWorkspace workspace;
  for (int round = 0; round < 100; ++round) {
    const Problem problem = make_problem(random, 60, 2, 20);
    std::vector<std::int16_t> a(60, 0);
    std::vector<std::int16_t> b(60, 1);
    REQUIRE(expand_labels(problem.graph, problem.unary, 2, a, workspace, {.prune = true}) ==
            expand_labels(problem.graph, problem.unary, 2, b, workspace, {.prune = false}));
  }
}
