#include "core/fitting/fit_template.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/fitting/point_graph.h"
#include "core/fitting/sample_costs.h"
#include "tests/support/made_shapes.h"
#include "tests/support/plain_fit.h"

using namespace archetype;

namespace {

GenerateOptions plain_chairs() {
  GenerateOptions options;
  options.styles = {family_names("chairs").styles.front()};
  return options;
}

ShapeSamples turned_samples(ShapeSamples samples, int quarters) {
  for (Vec3& p : samples.points) p = turn_quarters(p, quarters);
  for (Vec3& n : samples.normals) n = turn_quarters(n, quarters);
  if ((quarters & 1) != 0) std::swap(samples.features_x, samples.features_z);
  return samples;
}

}  // namespace

TEST_CASE("the energy never rises from one alternation to the next") {
  FitOptions options;
  options.drop_parts = false;  // a part that goes may cost
  for (const std::string& family : families()) {
    const PartTemplate part_template = test::template_from(test::make_shape(family, {}, 0, 500));
    for (std::size_t i = 1; i < 6; ++i) {
      const test::MadeShape shape = test::make_shape(family, {}, i, 500);
      FitRecording recording;
      const auto fit = fit_template(part_template, shape.samples, options, {}, &recording);
      REQUIRE(fit);
      REQUIRE(recording.steps.size() == static_cast<std::size_t>(fit->alternations) + 1);
      for (std::size_t s = 2; s < recording.steps.size(); ++s) {
        CHECK(recording.steps[s].energy.total() <= recording.steps[s - 1].energy.total());
      }
      CHECK(recording.steps.back().energy == fit->energy);
    }
  }
}

TEST_CASE("the plain alternation with Boost's cuts ends at the same energy") {
  const PartTemplate part_template = test::template_from(test::make_shape("chairs", plain_chairs(), 0, 400));
  for (std::size_t i = 0; i < 4; ++i) {
    const test::MadeShape shape = test::make_shape("chairs", plain_chairs(), i, 400);
    const auto fit = fit_template(part_template, shape.samples, {});
    const ShapeFit plain = test::plain_fit(part_template, shape.samples, {});
    CHECK(fit->energy.total() == doctest::Approx(plain.energy.total()).epsilon(0.001));
    CHECK(fit->yaw_quarters == plain.yaw_quarters);
  }
  // Chairs that lack some of the parts, and one that is found only in the second try.
  const PartTemplate armchair = test::template_from(test::make_shape("chairs", {}, 1, 400));
  for (const std::size_t i : {0, 7}) {
    const test::MadeShape shape = test::make_shape("chairs", {}, i, 400);
    const auto fit = fit_template(armchair, shape.samples, {});
    const ShapeFit plain = test::plain_fit(armchair, shape.samples, {});
    CHECK(fit->energy.total() == doctest::Approx(plain.energy.total()).epsilon(0.001));
  }
}

TEST_CASE("a shape that stands turned by quarters is found so, and labelled alike") {
  const test::MadeShape shape = test::make_shape("chairs", plain_chairs(), 0);
  const PartTemplate part_template = test::template_from(shape);
  const auto upright = fit_template(part_template, shape.samples, {});
  CHECK(upright->yaw_quarters == 0);
  for (int yaw = 1; yaw < 4; ++yaw) {
    const auto fit = fit_template(part_template, turned_samples(shape.samples, yaw), {});
    CHECK(fit->yaw_quarters == yaw);
    CHECK(fit->labels == upright->labels);
    CHECK(fit->energy.total() == doctest::Approx(upright->energy.total()).epsilon(1e-9));
  }
}

TEST_CASE("boxes follow parts that moved and grew") {
  const test::MadeShape shape = test::make_shape("tables", {}, 0);
  const PartTemplate truth = test::template_from(shape);
  PartTemplate moved = truth;
  for (TemplatePart& part : moved.parts) {
    part.position.mean += Vec3(0.05, -0.04, 0.03);
    part.scale.mean *= 1.15;
  }
  const auto fit = fit_template(moved, shape.samples, {});
  double before = 0;
  double after = 0;
  for (std::size_t k = 0; k < truth.parts.size(); ++k) {
    REQUIRE(fit->parts[k].present);
    const Box want = truth.parts[k].mean_box();
    const Box start = moved.parts[k].mean_box();
    const Box got = fit->parts[k].box;
    before += (start.centre - want.centre).norm() + (start.half_extent - want.half_extent).norm();
    after +=
        (got.centre + fit->translation - want.centre).norm() + (got.half_extent - want.half_extent).norm();
  }
  CHECK(after < 0.85 * before);  // all the way back would mean that the prior counts for nothing
}

TEST_CASE("boxes turn with parts that stand askew") {
  const test::MadeShape shape = test::make_shape("chairs", plain_chairs(), 0);
  PartTemplate part_template = test::template_from(shape);
  const auto turned_by = [](const Box& a, const Box& b) {
    return a.orientation.angularDistance(b.orientation);
  };
  // A template whose back leans by 15 degrees more than the shape's.
  const auto back = std::ranges::max_element(part_template.parts, {},
                                             [](const TemplatePart& each) { return each.position.mean.y(); });
  const std::size_t part = static_cast<std::size_t>(back - part_template.parts.begin());
  const Box upright = back->mean_box();
  back->orientation = back->orientation * Eigen::Quaterniond(Eigen::AngleAxisd(0.26, Vec3::UnitX()));
  FitOptions options;
  const auto turned = fit_template(part_template, shape.samples, options);
  options.turn_stddev = 0;
  const auto stiff = fit_template(part_template, shape.samples, options);
  CHECK(turned_by(turned->parts[part].box, upright) < 0.13);  // the prior holds it back
  CHECK(turned_by(stiff->parts[part].box, back->mean_box()) == 0);
  CHECK(turned->energy.total() < stiff->energy.total());
}

TEST_CASE("a part that must exist is missed dearly, one that need not costs little") {
  const test::MadeShape shape = test::make_shape("tables", {}, 1);
  PartTemplate part_template = test::template_from(shape);
  TemplatePart extra;
  extra.position.mean = Vec3(0, 30, 0);  // nothing of the shape is there
  extra.position.stddev = Vec3::Constant(0.05);
  extra.existence = 0.5;
  part_template.parts.push_back(extra);
  const auto optional = fit_template(part_template, shape.samples, {});
  CHECK_FALSE(optional->parts.back().present);
  CHECK(optional->energy.total() < 2);
  part_template.parts.back().must_exist = true;
  const auto required = fit_template(part_template, shape.samples, {});
  CHECK(required->energy.total() > 900);
}

TEST_CASE("optional parts stay where a shape has them and go where it lacks them") {
  GenerateOptions with_arms;
  with_arms.styles = {"arms"};
  const test::MadeShape armchair = test::make_shape("chairs", with_arms, 0);
  PartTemplate part_template = test::template_from(armchair);
  const auto& names = family_names("chairs").labels;
  const auto arm = static_cast<int>(std::find(names.begin(), names.end(), "arm") - names.begin());
  for (TemplatePart& part : part_template.parts) part.existence = part.label == arm ? 0.5 : 0.9;
  FitOptions keep;
  keep.drop_parts = false;
  const auto arms_of = [&](const test::MadeShape& shape, const FitOptions& options) {
    FitRecording recording;
    const auto fit = fit_template(part_template, shape.samples, options, {}, &recording);
    CHECK(recording.steps.size() == static_cast<std::size_t>(fit->alternations) + 1);
    CHECK(recording.steps.back().energy == fit->energy);
    int present = 0;
    for (std::size_t k = 0; k < fit->parts.size(); ++k) {
      if (!fit->parts[k].present) CHECK(fit->parts[k].box.centre == part_template.parts[k].position.mean);
      if (part_template.parts[k].label == arm && fit->parts[k].present) ++present;
    }
    return present;
  };
  int kept_on_plain = 0;
  int dropped_on_plain = 0;
  int on_armchairs = 0;
  for (std::size_t i = 1; i <= 8; ++i) {
    const test::MadeShape plain = test::make_shape("chairs", plain_chairs(), i);
    kept_on_plain += arms_of(plain, keep);
    dropped_on_plain += arms_of(plain, {});
    on_armchairs += arms_of(test::make_shape("chairs", with_arms, i), {});
  }
  // Four boxes a chair: two rests and what holds them.
  CHECK(kept_on_plain >= 16);
  CHECK(2 * dropped_on_plain <= kept_on_plain);
  CHECK(on_armchairs >= 26);
}

TEST_CASE("a narrow template with parts that hardly any shape has does not turn the shapes") {
  GenerateOptions with_arms;
  with_arms.styles = {"arms"};
  PartTemplate part_template = test::template_from(test::make_shape("chairs", with_arms, 0));
  const auto& names = family_names("chairs").labels;
  const auto arm = static_cast<int>(std::find(names.begin(), names.end(), "arm") - names.begin());
  for (TemplatePart& part : part_template.parts) {
    part.position.stddev *= 0.4;
    part.scale.stddev *= 0.4;
    part.existence = part.label == arm ? 0.01 : 0.99;
  }
  for (const bool arms : {false, true}) {
    for (int i = 1; i <= 8; ++i) {
      const test::MadeShape shape =
          test::make_shape("chairs", arms ? with_arms : plain_chairs(), static_cast<std::size_t>(i));
      CAPTURE(arms);
      CAPTURE(i);
      FitRecording recording;
      const auto fit = fit_template(part_template, turned_samples(shape.samples, i % 4), {}, {}, &recording);
      REQUIRE(fit);
      CHECK(fit->yaw_quarters == i % 4);
      CHECK(std::ranges::min_element(fit->yaw_energies) - fit->yaw_energies.begin() == fit->yaw_quarters);
      REQUIRE(recording.steps.size() == static_cast<std::size_t>(fit->alternations) + 1);
      CHECK(recording.steps.back().energy == fit->energy);
    }
  }
}

TEST_CASE("a part whose mean box lies far from it is found from boxes that the first fit carries") {
  const PartTemplate part_template = test::template_from(test::make_shape("chairs", {}, 1));
  const test::MadeShape shape = test::make_shape("chairs", {}, 7);
  const auto far_off = std::size_t{0};  // the first try leaves it out, and ends at 0.47
  FitRecording recording;
  const auto fit = fit_template(part_template, shape.samples, {}, {}, &recording);
  CHECK(fit->parts[far_off].present);
  CHECK(fit->energy.total() < 0.4);
  REQUIRE(recording.steps.size() == static_cast<std::size_t>(fit->alternations) + 1);
  CHECK(recording.steps.back().energy == fit->energy);
  CHECK(recording.steps.back().labels == fit->labels);
  // What is pinned holds in the second try, too.
  const auto own = static_cast<std::size_t>(
      std::ranges::find(fit->labels, static_cast<std::int16_t>(far_off)) - fit->labels.begin());
  const std::vector<PinnedLabel> pinned{{static_cast<std::uint32_t>(own), 1}};
  const auto held = fit_template(part_template, shape.samples, {}, {}, nullptr, pinned);
  CHECK(held->parts[far_off].present);
  CHECK(held->labels[own] == 1);
}

TEST_CASE("live refits start from the fit that is there") {
  const test::MadeShape shape = test::make_shape("chairs", {}, 2);
  const PartTemplate part_template = test::template_from(shape);
  const auto fit = fit_template(part_template, shape.samples, {});
  const auto again = refit_template(part_template, shape.samples, *fit, {});
  CHECK(again->yaw_quarters == fit->yaw_quarters);
  CHECK(again->energy.total() <= fit->energy.total() * 1.02);
  PartTemplate fewer = part_template;
  fewer.parts.pop_back();  // labels of the old fit name a part that is gone
  CHECK(refit_template(fewer, shape.samples, *fit, {})->parts.size() == fewer.parts.size());
}

TEST_CASE("while a box is dragged, fits follow the one before") {
  const test::MadeShape shape = test::make_shape("chairs", {}, 2);
  PartTemplate moved = test::template_from(shape);
  const LabellingGraph graph = make_point_graph(shape.samples, {});
  ShapeFit fit = *fit_template(moved, shape.samples, {});
  for (int step = 0; step < 10; ++step) {
    moved.parts[1].position.mean.y() += 0.03;
    fit = *follow_template(moved, shape.samples, graph, fit, {});
    const ShapeFit anew = *refit_template(moved, shape.samples, fit, {});
    CHECK(fit.energy.total() <= anew.energy.total() * 1.02);
    CHECK(fit.yaw_energies[static_cast<std::size_t>(fit.yaw_quarters)] == fit.energy.total());
  }
  PartTemplate fewer = moved;
  fewer.parts.pop_back();  // labels of the old fit name a part that is gone
  CHECK(follow_template(fewer, shape.samples, graph, fit, {})->parts.size() == fewer.parts.size());
}

TEST_CASE("what samples cost adds up to the energy that they give the fit, and tells where it is bad") {
  const test::MadeShape shape = test::make_shape("chairs", {}, 2);
  PartTemplate part_template = test::template_from(shape);
  for (const int yaw : {0, 1}) {
    FitOptions options;
    options.yaw_costs.fill(std::numeric_limits<double>::infinity());
    options.yaw_costs[static_cast<std::size_t>(yaw)] = 0;
    const ShapeFit fit = *fit_template(part_template, shape.samples, options);
    const std::vector<double> costs = sample_costs(part_template, shape.samples, fit, options);
    REQUIRE(costs.size() == shape.samples.size());
    double sum = 0;
    for (const double cost : costs) sum += cost;
    CHECK(sum / static_cast<double>(costs.size()) ==
          doctest::Approx(fit.energy.shape_to_template + fit.energy.features).epsilon(0.01));
    for (std::size_t i = 0; i < costs.size(); ++i)
      if (fit.labels[i] == null_label) CHECK(costs[i] == options.null_cost);
  }
}

TEST_CASE("fits are the same bytes on every thread") {
  const test::MadeShape shape = test::make_shape("planes", {}, 0, 500);
  const PartTemplate part_template = test::template_from(test::make_shape("planes", {}, 1, 500));
  std::vector<ShapeFit> fits(6);
  for (const unsigned threads : {1U, 2U, 8U}) {
    parallel_for(fits.size(), threads, {}, "fitting",
                 [&](std::size_t i) { fits[i] = *fit_template(part_template, shape.samples, {}); });
    for (const ShapeFit& fit : fits) {
      CHECK(fit.labels == fits[0].labels);
      CHECK(fit.energy == fits[0].energy);
      CHECK(fit.translation == fits[0].translation);
    }
  }
}

TEST_CASE("cancelled and impossible fits") {
  const test::MadeShape shape = test::make_shape("tables", {}, 0, 200);
  const PartTemplate part_template = test::template_from(shape);
  std::stop_source source;
  source.request_stop();
  CHECK_FALSE(fit_template(part_template, shape.samples, {}, {source.get_token(), {}}));
  CHECK_THROWS_AS(fit_template({}, shape.samples, {}), PreconditionError);
  CHECK_THROWS_AS(fit_template(part_template, {}, {}), PreconditionError);
}
