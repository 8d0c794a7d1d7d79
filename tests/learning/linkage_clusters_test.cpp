#include "core/learning/linkage_clusters.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace archetype;

TEST_CASE("complete linkage joins what lies near, and the farthest members decide") {
  // A chain of three and one point beyond: single linkage would join them all before the pair on the right.
  Eigen::MatrixXd points(6, 1);
  points << 0, 1, 2, 3.2, 10, 10.5;
  const auto two = linkage_clusters(points, 2);
  REQUIRE(two.size() == 2);
  CHECK(two[0] == std::vector<std::size_t>{0, 1, 2, 3});
  CHECK(two[1] == std::vector<std::size_t>{4, 5});
  const auto three = linkage_clusters(points, 3);
  REQUIRE(three.size() == 3);
  CHECK(three[0] == std::vector<std::size_t>{0, 1});
  CHECK(three[1] == std::vector<std::size_t>{2, 3});
  CHECK(linkage_clusters(points, 9).size() == 6);
  CHECK(linkage_clusters(Eigen::MatrixXd(0, 1), 2).empty());
}

TEST_CASE("principal directions keep distances, the widest one first") {
  Eigen::MatrixXd rows(4, 3);
  rows << 0, 0, 0, 3, 3, 0, 6, 6, 0.5, 9, 9, -0.5;
  const Eigen::MatrixXd one = principal_directions(rows, 1);
  REQUIRE(one.cols() == 1);
  CHECK(std::abs(one(3, 0) - one(0, 0)) == doctest::Approx(9 * std::sqrt(2.0)).epsilon(0.01));
  const Eigen::MatrixXd all = principal_directions(rows, 4);
  REQUIRE(all.cols() == 3);
  CHECK((all.row(2) - all.row(0)).norm() == doctest::Approx((rows.row(2) - rows.row(0)).norm()));
}
