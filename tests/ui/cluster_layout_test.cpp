// Where clusters and their members stand, and the ways of the arrow keys through them.
#include "ui/cluster_layout.h"

#include <doctest/doctest.h>

#include <numeric>

using namespace archetype;

namespace {

ShapeCluster cluster_of(std::size_t count, std::size_t first) {
  ShapeCluster cluster;
  cluster.shown.resize(count);
  std::iota(cluster.shown.begin(), cluster.shown.end(), first);
  cluster.all = count;
  return cluster;
}

}  // namespace

TEST_CASE("Sections stand below each other; lines beside the card, or all of them") {
  const std::vector clusters{cluster_of(5, 0), cluster_of(0, 5), cluster_of(1000, 5)};
  const std::vector<float> cards{200, 200, 200};
  ClusterMeasures measures;
  measures.width = 800;
  const ClusterLayout few = lay_out_clusters(measures, clusters, cards, {false, false, false});
  REQUIRE(few.sections.size() == 3);
  CHECK(few.columns >= 4);
  const float right = few.cell_left(few.columns - 1) + few.cell_width;
  CHECK(right <= measures.width + 0.5f);
  for (std::size_t i = 1; i < 3; ++i)
    CHECK(few.sections[i].top >= few.sections[i - 1].top + few.sections[i - 1].height);
  CHECK(few.sections[2].cut);
  CHECK(few.sections[2].lines * few.columns < 30);
  CHECK(few.sections[1].height >= 200);
  const ClusterLayout all = lay_out_clusters(measures, clusters, cards, {false, false, true});
  CHECK_FALSE(all.sections[2].cut);
  CHECK(all.sections[2].lines * all.columns >= 1000);
  CHECK(all.height > few.height + 10'000);
  // However narrow: at least one column.
  measures.width = 40;
  CHECK(lay_out_clusters(measures, clusters, cards, {true, true, true}).columns == 1);
}

TEST_CASE("Arrow keys lead through lines and over empty clusters, and stay at the ends") {
  const std::vector clusters{cluster_of(7, 0), cluster_of(0, 7), cluster_of(3, 7)};
  const std::vector<float> cards{400, 100, 400};
  ClusterMeasures measures;
  measures.width = measures.card_width + 2 * measures.gap + 4 * measures.cell_width + 3 * measures.gap;
  const ClusterLayout layout = lay_out_clusters(measures, clusters, cards, {true, true, true});
  REQUIRE(layout.columns == 4);
  const auto step = [&](std::size_t section, std::size_t index, CellStep to) {
    return step_cell(layout, clusters, {section, index}, to);
  };
  CHECK(step(0, 0, CellStep::left) == CellPlace{0, 0});
  CHECK(step(0, 0, CellStep::up) == CellPlace{0, 0});
  CHECK(step(0, 0, CellStep::right) == CellPlace{0, 1});
  CHECK(step(0, 6, CellStep::right) == CellPlace{2, 0});
  CHECK(step(2, 0, CellStep::left) == CellPlace{0, 6});
  CHECK(step(0, 1, CellStep::down) == CellPlace{0, 5});
  CHECK(step(0, 3, CellStep::down) == CellPlace{0, 6});  // the last line is shorter
  CHECK(step(0, 6, CellStep::down) == CellPlace{2, 2});
  CHECK(step(2, 2, CellStep::up) == CellPlace{0, 6});
  CHECK(step(2, 0, CellStep::up) == CellPlace{0, 4});
  CHECK(step(2, 2, CellStep::right) == CellPlace{2, 2});
  CHECK(find_cell(clusters, 8) == CellPlace{2, 1});
  CHECK_FALSE(find_cell(clusters, 99));
}
