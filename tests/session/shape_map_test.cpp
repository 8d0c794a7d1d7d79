// The map of a collection, and the shapes nearest to what is wished.
#include "core/session/shape_map.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/base/random.h"
#include "core/session/nearest_shapes.h"
#include "tests/report/made_reports.h"

using namespace archetype;
using namespace archetype::test;

namespace {

float distance(const MapPoint& a, const MapPoint& b) {
  return std::hypot(a.at[0] - b.at[0], a.at[1] - b.at[1]);
}

// Fits of one template of `parts` parts whose heights and widths vary by two hidden numbers.
FitTable two_ways(std::size_t count, std::size_t parts) {
  FitTable table;
  table.templates.resize(1);
  for (std::size_t p = 0; p < parts; ++p) {
    TemplatePart part;
    part.name = "part " + std::to_string(p);
    part.label = static_cast<int>(p);
    table.templates[0].part_template.parts.push_back(part);
  }
  RandomStream random(5);
  for (std::size_t i = 0; i < count; ++i) {
    FitTableRow row;
    row.summary.shape = static_cast<ShapeId>(i + 1);
    row.first_part = table.parts.size();
    table.rows.push_back(row);
    const double tall = random.uniform(-1, 1);
    const double wide = random.uniform(-0.3, 0.3);
    for (std::size_t p = 0; p < parts; ++p)
      table.parts.push_back({true, {{0, 0.2 * tall, 0}, {0.2 + 0.1 * wide, 0.2, 0.2}}, 0.1});
  }
  return table;
}

}  // namespace

TEST_CASE("the map's axes are what the shapes vary in, the stronger first") {
  const FitTable table = two_ways(200, 3);
  for (const std::optional<std::size_t> of : {std::optional<std::size_t>(0), std::optional<std::size_t>()}) {
    const auto map = map_of_shapes(table, of, {});
    REQUIRE(map);
    REQUIRE(map->points.size() == 200);
    CHECK(map->axes[0].share >= map->axes[1].share);
    CHECK(map->axes[0].share + map->axes[1].share == doctest::Approx(1).epsilon(1e-6));
    double middle = 0;
    for (const MapPoint& point : map->points) middle += point.at[0];
    CHECK(middle / 200 == doctest::Approx(0).epsilon(1e-3));
  }
  const auto map = map_of_shapes(table, 0, {});
  CHECK(map->axes[0].meaning.find("height above ground") != std::string::npos);
  CHECK(map->axes[1].meaning.find("width") != std::string::npos);
  // One standard deviation of the template is one unit, for each of the three parts.
  CHECK(
      map->points[0].at[0] - map->points[1].at[0] ==
      doctest::Approx(std::sqrt(3.0) * (table.parts[0].box.centre.y() - table.parts[3].box.centre.y()) / 0.2)
          .epsilon(0.1));
}

TEST_CASE("the map over all templates compares parts by their labels; lost shapes are outliers") {
  const FitTable table = made_fits(60);
  const auto map = map_of_shapes(table, std::nullopt, {});
  REQUIRE(map);
  REQUIRE(map->points.size() == 60);
  CHECK(map->points[4].outlier);
  CHECK_FALSE(map->points[3].outlier);
  CHECK(map->points[2].part_template == 1);
  CHECK(map->points[2].shape == 3);
  // Of the second template, which has no back, shapes 3 and 6 are as near each other as their seats are; a
  // shape with a back is elsewhere.
  CHECK(distance(map->points[2], map->points[5]) < distance(map->points[2], map->points[4]));
  const auto one = map_of_shapes(table, 1, {});
  CHECK(one->points.size() == 20);
  CHECK(one->axes[0].share == doctest::Approx(1));
}

TEST_CASE("the same fits give the same map, whatever the order of the shapes") {
  const FitTable table = made_fits(50);
  FitTable turned = table;
  std::ranges::reverse(turned.rows);
  const auto map = map_of_shapes(table, std::nullopt, {});
  const auto again = map_of_shapes(table, std::nullopt, {});
  const auto other = map_of_shapes(turned, std::nullopt, {});
  for (std::size_t i = 0; i < 50; ++i) {
    CHECK(map->points[i].at == again->points[i].at);
    CHECK(distance(map->points[i], other->points[49 - i]) < 1e-4f);
  }
}

TEST_CASE("a map of nothing, of one shape, and of fits that are no numbers") {
  CHECK(map_of_shapes({}, std::nullopt, {})->points.empty());
  const auto one = map_of_shapes(made_fits(1), std::nullopt, {});
  REQUIRE(one->points.size() == 1);
  CHECK(one->points[0].at == std::array<float, 2>{0, 0});
  CHECK(map_of_shapes(made_fits(3), 7, {})->points.empty());
  FitTable broken = made_fits(20);
  broken.parts[3].box.centre = {NAN, INFINITY, 1e300};
  broken.parts[5].box.half_extent.setConstant(NAN);
  broken.templates[0].part_template.parts[0].position.stddev.setZero();
  for (const std::optional<std::size_t> of : {std::optional<std::size_t>(0), std::optional<std::size_t>()}) {
    const auto map = map_of_shapes(broken, of, {});
    for (const MapPoint& point : map->points) {
      CHECK(std::isfinite(point.at[0]));
      CHECK(std::isfinite(point.at[1]));
    }
  }
  std::stop_source stop;
  stop.request_stop();
  JobControl control;
  control.stop = stop.get_token();
  CHECK_FALSE(map_of_shapes(made_fits(10), std::nullopt, control));
}

TEST_CASE("ten thousand shapes, and hundreds of parts, are mapped in no time") {
  const auto start = std::chrono::steady_clock::now();
  CHECK(map_of_shapes(two_ways(10'000, 6), 0, {})->points.size() == 10'000);
  CHECK(map_of_shapes(two_ways(500, 200), std::nullopt, {})->points.size() == 500);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  MESSAGE("maps: ", seconds, " s");
  CHECK(seconds < 10);
}

TEST_CASE("the nearest shapes are those with the parts where they are wished") {
  const FitTable table = made_fits(60);
  // The seat's height is i / 60, its mean 0.5, its deviation 0.25: at +1 it is 0.75, which shape 46 has.
  std::vector<PartWish> wishes(2);
  wishes[0][1] = 1;
  const auto nearest = nearest_shapes(table, 0, wishes, 5);
  REQUIRE(nearest.size() == 5);
  CHECK(nearest[0].shape == 46);
  CHECK(nearest[0].distance == doctest::Approx(0));
  for (std::size_t i = 1; i < nearest.size(); ++i) CHECK(nearest[i].distance >= nearest[i - 1].distance);
  // Against all of them, one by one.
  double least_left_out = 1e9;
  for (const FitTableRow& row : table.rows) {
    if (row.part_template != 0) continue;
    const bool taken = std::ranges::find(nearest, row.summary.shape, &NearShape::shape) != nearest.end();
    const double height = table.parts_of(row)[0].box.centre.y();
    if (!taken) least_left_out = std::min(least_left_out, std::abs((height - 0.5) / 0.25 - 1));
  }
  CHECK(nearest.back().distance <= least_left_out + 1e-12);
}

TEST_CASE("a part that a shape lacks is far from every wish; without a wish the average comes first") {
  const FitTable table = made_fits(60);
  std::vector<PartWish> wishes(2);
  wishes[1][1] = 0;
  const auto with_back = nearest_shapes(table, 0, wishes, 100);
  REQUIRE(with_back.size() == 40);
  CHECK(with_back[0].distance == doctest::Approx(0));
  CHECK(with_back.back().distance == 4);
  const auto average = nearest_shapes(table, 0, {}, 3);
  REQUIRE(average.size() == 3);
  CHECK(nearest_shapes(table, 9, {}, 3).empty());
  CHECK(nearest_shapes({}, 0, {}, 3).empty());
  CHECK(nearest_shapes(table, 1, std::vector<PartWish>(7), 100).size() == 20);  // more wishes than parts
}

TEST_CASE("the wished template has its boxes where the wishes are") {
  const PartTemplate chair = made_fits(1).templates[0].part_template;
  std::vector<PartWish> wishes(1);
  wishes[0][0] = 2;
  wishes[0][4] = -100;  // nothing is smaller than nothing
  const PartTemplate wished = wished_template(chair, wishes);
  CHECK(wished.parts[0].position.mean.x() == doctest::Approx(0.5));
  CHECK(wished.parts[0].scale.mean.y() == doctest::Approx(1e-3));
  CHECK(wished.parts[1] == chair.parts[1]);
  CHECK(wished_template(chair, std::vector<PartWish>(9)) == chair);
}
