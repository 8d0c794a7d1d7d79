// Sorting, filtering and grouping of shapes, on made rows.
#include <doctest/doctest.h>

#include <chrono>
#include <cmath>
#include <limits>

#include "core/session/shape_clusters.h"
#include "core/session/shape_filter.h"

using namespace archetype;

namespace {

using Rows = std::vector<std::size_t>;

TemplatePart part(const char* name, double spread) {
  TemplatePart made;
  made.name = name;
  made.position.stddev = Vec3::Constant(0.1);
  made.scale.stddev = Vec3(0.1, spread, 0.1);
  return made;
}

// Two templates that share the part "seat"; the shapes take turns, every fifth is an outlier, and every
// seventh has no fit.
struct Made {
  std::vector<ShapeRow> rows;
  FitTable table;

  explicit Made(std::size_t count) {
    table.templates.resize(2);
    table.templates[0].id = 10;
    table.templates[0].part_template = {"chair", {part("seat", 0.1), part("back", 0.4)}, ""};
    table.templates[1].id = 11;
    table.templates[1].part_template = {"stool", {part("leg", 0.1), part("seat", 0.2)}, ""};
    for (std::size_t i = 0; i < count; ++i) {
      ShapeRow row;
      row.id = static_cast<ShapeId>(i + 1);
      row.name = "Shape_" + std::to_string(i);
      if (i % 7 != 6) {
        FitSummary fit;
        fit.shape = row.id;
        fit.part_template = i % 2 == 0 ? 10 : 11;
        fit.status = i % 5 == 4 ? FitStatus::outlier : i % 3 == 0 ? FitStatus::learned : FitStatus::fitted;
        fit.energy.deformation = static_cast<double>(i * 37 % 101) / 100;
        row.fit = fit;
        table.rows.push_back({fit, i % 2, table.parts.size(), Vec3::Zero()});
        for (int k = 0; k < 2; ++k) {
          PartValues values;
          values.present = k == 0 || i % 4 < 2;
          values.box.centre = Vec3(0.01 * static_cast<double>(i % 50), k, 0);
          values.box.half_extent = Vec3(1, 0.5, 0.25);
          values.share = 0.5;
          table.parts.push_back(values);
        }
      }
      rows.push_back(row);
    }
  }
  ShapeTable shapes() const { return {rows, &table}; }
};

}  // namespace

TEST_CASE("Names are searched by words, whatever their case") {
  std::vector<ShapeRow> rows;
  for (const char* name : {"armchair red", "Bench", "Red chair"})
    rows.push_back({static_cast<ShapeId>(rows.size()), name, rows.size(), {}, {}});
  const auto found = [&](const char* text) {
    return shown_rows(ShapeTable(rows, nullptr), {.name = text}, {});
  };
  CHECK(found("") == Rows{0, 1, 2});
  CHECK(found("CHAIR") == Rows{0, 2});
  CHECK(found("  chair  RED ") == Rows{0, 2});
  CHECK(found("bench chair").empty());
}

TEST_CASE("Shapes are sorted by their numbers; those without one come last, equal ones by name") {
  std::vector<ShapeRow> rows;
  for (const char* name : {"a", "b", "c", "d"})
    rows.push_back({static_cast<ShapeId>(rows.size()), name, rows.size(), {}, {}});
  for (const std::size_t fitted : {0, 2, 3}) {
    rows[fitted].fit.emplace();
    rows[fitted].fit->energy.features = fitted == 2 ? 0.1 : 0.9;
    rows[fitted].fit->energy.smoothness = static_cast<double>(fitted);
  }
  const auto sorted = [&](ShapeQuantity quantity, bool descending) {
    return shown_rows(ShapeTable(rows, nullptr), {}, {{.quantity = quantity}, descending});
  };
  CHECK(sorted(ShapeQuantity::name, false) == Rows{0, 1, 2, 3});
  CHECK(sorted(ShapeQuantity::name, true) == Rows{3, 2, 1, 0});
  CHECK(sorted(ShapeQuantity::elements, true) == Rows{3, 2, 1, 0});
  CHECK(sorted(ShapeQuantity::features, false) == Rows{2, 0, 3, 1});
  CHECK(sorted(ShapeQuantity::features, true) == Rows{0, 3, 2, 1});
  CHECK(sorted(ShapeQuantity::energy, true) == Rows{3, 2, 0, 1});
  // Without a table of fits nothing is known of parts: no order, and no mistake.
  CHECK(sorted(ShapeQuantity::part_x, true) == Rows{0, 1, 2, 3});
}

TEST_CASE("Templates, statuses and shapes without a fit are hidden") {
  const Made made(70);
  const auto count = [&](const ShapeFilter& filter) { return shown_rows(made.shapes(), filter, {}).size(); };
  CHECK(count({}) == 70);
  CHECK(count({.hide_unfitted = true}) == 60);
  CHECK(count({.hidden_templates = {10}}) == 70 - 30);
  CHECK(count({.hidden_templates = {10, 11}}) == 10);
  CHECK(count({.hidden_templates = {99}}) == 70);  // one that is gone hides nothing
  CHECK(count({.hidden_statuses = {FitStatus::outlier}}) == 70 - 12);
  ShapeFilter filter;
  CHECK(is_empty(filter));
  toggle_hidden(filter.hidden_templates, TemplateId{10});
  CHECK(condition_count(filter) == 1);
  toggle_hidden(filter.hidden_templates, TemplateId{10});
  CHECK(is_empty(filter));
}

TEST_CASE("Parts count by their names over all templates, present or absent") {
  const Made made(70);
  const auto found = [&](const char* name, bool present) {
    return shown_rows(made.shapes(), {.parts = {{name, present}}}, {});
  };
  for (const std::size_t row : found("seat", true)) {
    CHECK(made.rows[row].fit);
    CHECK((row % 2 == 0 || row % 4 < 2));
  }
  CHECK(found("seat", true).size() + found("seat", false).size() == 70);
  CHECK(found("leg", true).size() == 30);  // the first part of every stool
  CHECK(found("no such part", true).empty());
  CHECK(found("no such part", false).size() == 70);
  CHECK(found("seat", false).size() >= 10);  // what has no fit has no parts
}

TEST_CASE("Ranges keep both ends, and leave out what has no such number") {
  const Made made(70);
  const ShapeColumn x{.quantity = ShapeQuantity::part_x, .part = "seat"};
  ShapeFilter filter;
  set_range(filter, x, 0.20, 0.10);
  REQUIRE(find_range(filter, x));
  CHECK(find_range(filter, x)->low == 0.10);
  const Rows shown = shown_rows(made.shapes(), filter, {x, true});
  REQUIRE_FALSE(shown.empty());
  const std::vector<double> values = column_values(made.shapes(), x);
  for (std::size_t i = 0; i < shown.size(); ++i) {
    CHECK(values[shown[i]] >= 0.10);
    CHECK(values[shown[i]] <= 0.20);
    if (i > 0) CHECK(values[shown[i]] <= values[shown[i - 1]]);
  }
  set_range(filter, x, -HUGE_VAL, HUGE_VAL);  // open at both ends: all that have the part
  CHECK(shown_rows(made.shapes(), filter, {}) == shown_rows(made.shapes(), {.parts = {{"seat", true}}}, {}));
  clear_range(filter, x);
  CHECK(is_empty(filter));
  CHECK(needs_fit_table(x));
  CHECK_FALSE(needs_fit_table(ShapeColumn{.quantity = ShapeQuantity::deformation}));
}

TEST_CASE("Similarity is the distance of deformation parameters, in standard deviations") {
  Made made(12);
  const ShapeColumn to_first{.quantity = ShapeQuantity::similarity, .shape = 1};
  const std::vector<double> values = column_values(made.shapes(), to_first);
  CHECK(values[0] == 0);
  // Shape 4 is of the same template with the same parts: both are moved by 0.04, spread 0.1, of 12 numbers.
  CHECK(values[4] == doctest::Approx(std::sqrt(2 * 0.16 / 12)));
  CHECK(std::isnan(values[6]));  // no fit
  CHECK(values[2] > values[4]);  // lacks the back
  CHECK(values[1] > values[8]);  // another template
  CHECK(std::isfinite(values[1]));
  const Rows order = shown_rows(made.shapes(), {}, {to_first, false});
  CHECK(order.front() == 0);
  CHECK(order.back() == 6);
  // A shape that is gone: no order, and no mistake.
  CHECK(shown_rows(made.shapes(), {}, {{.quantity = ShapeQuantity::similarity, .shape = 99}, false}).size() ==
        12);
}

TEST_CASE("Histograms count what is shown over the range of all, and no outlier presses them flat") {
  std::vector<double> values;
  for (int i = 0; i < 1000; ++i) values.push_back(i / 1000.0);
  values.push_back(1e6);
  values.push_back(std::numeric_limits<double>::quiet_NaN());
  Rows all(values.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  const Histogram whole = histogram(values, all, 20);
  CHECK(whole.total == 1001);
  CHECK(whole.low == 0);
  CHECK(whole.high < 3);
  CHECK(whole.counts.back() >= 1);
  std::size_t sum = 0;
  for (const std::size_t count : whole.counts) sum += count;
  CHECK(sum == whole.total);
  const Histogram some = histogram(values, Rows{1, 2, 3}, 20);
  CHECK(some.low == whole.low);
  CHECK(some.high == whole.high);
  CHECK(some.total == 3);
  const Histogram same = histogram(std::vector<double>(5, 2.0), Rows{0, 1, 2, 3, 4}, 4);
  CHECK(same.high > same.low);
  CHECK(same.total == 5);
  CHECK(histogram({}, {}, 4).total == 0);
}

TEST_CASE("Clusters hold each shown shape once; outliers worst first, and shapes without a fit, apart") {
  const Made made(70);
  const Rows all = shown_rows(made.shapes(), {}, {});
  const auto clusters = shape_clusters(made.shapes(), all, true);
  REQUIRE(clusters.size() == 4);
  std::size_t shown = 0;
  for (const ShapeCluster& cluster : clusters) {
    CHECK(cluster.shown.size() == cluster.all);
    shown += cluster.shown.size();
  }
  CHECK(shown == 70);
  CHECK(clusters[0].part_template == 0);
  CHECK(clusters[1].part_template == 1);
  CHECK(clusters[2].kind == ClusterKind::outliers);
  CHECK(clusters[3].kind == ClusterKind::unfitted);
  CHECK(clusters[3].all == 10);
  const auto energy = [&](std::size_t row) { return made.rows[row].fit->energy.total(); };
  for (std::size_t i = 1; i < clusters[2].shown.size(); ++i)
    CHECK(energy(clusters[2].shown[i - 1]) >= energy(clusters[2].shown[i]));
  double sum = 0;
  for (const std::size_t row : clusters[0].shown) sum += energy(row);
  CHECK(clusters[0].mean_energy == doctest::Approx(sum / static_cast<double>(clusters[0].all)));
  // What is filtered out still counts as a member.
  const auto few = shape_clusters(made.shapes(), Rows{0}, true);
  CHECK(few[0].shown == Rows{0});
  CHECK(few[0].all == clusters[0].all);
  CHECK(few[0].mean_energy == clusters[0].mean_energy);
  // Without a table nothing is lost.
  const auto unknown = shape_clusters(ShapeTable(made.rows, nullptr), all, true);
  std::size_t without = 0;
  for (const ShapeCluster& cluster : unknown) without += cluster.shown.size();
  CHECK(without == 70);
}

TEST_CASE("Ten thousand shapes are filtered and sorted by parts in less than 100 milliseconds") {
  const Made made(10'000);
  ShapeFilter filter{.name = "shape 1", .hidden_statuses = {FitStatus::outlier}, .parts = {{"seat", true}}};
  set_range(filter, {.quantity = ShapeQuantity::energy}, 0.1, 0.9);
  set_range(filter, {.quantity = ShapeQuantity::part_x, .part = "seat"}, 0.0, 0.3);
  const auto start = std::chrono::steady_clock::now();
  const ShapeTable shapes = made.shapes();
  const Rows shown = shown_rows(shapes, filter, {{.quantity = ShapeQuantity::similarity, .shape = 1}, false});
  const auto clusters = shape_clusters(shapes, shown, false);
  const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
  MESSAGE("took ", took.count(), " ms");
  CHECK(took.count() < 100);
  CHECK(shown.size() > 100);
  CHECK(clusters.size() >= 3);
}
