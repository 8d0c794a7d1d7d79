// What was corrected by hand holds in the fit, in the labels of faces and in no other shape.
#include "core/fitting/pinned_labels.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/evaluation/label_elements.h"
#include "core/fitting/fit_template.h"
#include "tests/support/made_shapes.h"

using namespace archetype;

namespace {

PartTemplate seat_and_leg() {
  PartTemplate part_template;
  part_template.parts.resize(2);
  part_template.parts[0].name = "seat";
  part_template.parts[1].name = "leg";
  return part_template;
}

// Every third sample, as label `label`.
std::vector<PinnedLabel> every_third(std::size_t samples, std::int16_t label) {
  std::vector<PinnedLabel> pinned;
  for (std::uint32_t i = 0; i < samples; i += 3) pinned.push_back({i, label});
  return pinned;
}

}  // namespace

TEST_CASE("pinned samples are those of the parts that a template has") {
  const PinnedParts pinned{{"seat", {1, 7}}, {"leg", {0, 99}}, {"", {3}}, {"wing", {4}}};
  const std::vector<PinnedLabel> expected{{0, 1}, {1, 0}, {3, null_label}, {7, 0}};
  CHECK(pinned_labels(pinned, seat_and_leg(), 10) == expected);
  CHECK(pinned_labels({}, seat_and_leg(), 10).empty());
}

TEST_CASE("a pinned yaw is the only one that costs nothing") {
  ShapeCorrection correction;
  const std::array<double, 4> costs{0, 0.1, 0.2, 0.3};
  CHECK(pinned_yaw_costs(costs, correction) == costs);
  correction.yaw_quarters = 2;
  const auto pinned = pinned_yaw_costs(costs, correction);
  for (std::size_t yaw = 0; yaw < 4; ++yaw) CHECK(std::isinf(pinned[yaw]) == (yaw != 2));
}

TEST_CASE("a template that is pinned is the only one, where there is one of that name") {
  const std::vector<std::string> names{"chair", "bench"};
  ShapeCorrection correction;
  CHECK(allowed_templates(correction, names) == std::vector<bool>{true, true});
  correction.part_template = "bench";
  CHECK(allowed_templates(correction, names) == std::vector<bool>{false, true});
  correction.part_template = "sofa";
  CHECK(allowed_templates(correction, names) == std::vector<bool>{true, true});
}

TEST_CASE("pinned samples keep their labels through the whole fit, and their part stays") {
  const test::MadeShape shape = test::make_shape("chairs", {}, 0, 400);
  const PartTemplate part_template = test::template_from(shape);
  const auto free = fit_template(part_template, shape.samples, {});
  REQUIRE(free);
  for (std::int16_t label = null_label; label < static_cast<std::int16_t>(part_template.parts.size());
       ++label) {
    const auto pinned = every_third(shape.samples.size(), label);
    const auto fit = fit_template(part_template, shape.samples, {}, {}, nullptr, pinned);
    REQUIRE(fit);
    CHECK(std::ranges::all_of(pinned, [&](const PinnedLabel& p) { return fit->labels[p.sample] == label; }));
    if (label != null_label) CHECK(fit->parts[static_cast<std::size_t>(label)].present);
    const auto again = refit_template(part_template, shape.samples, *free, {}, {}, pinned);
    CHECK(
        std::ranges::all_of(pinned, [&](const PinnedLabel& p) { return again->labels[p.sample] == label; }));
  }
  CHECK_THROWS_AS(
      fit_template(part_template, shape.samples, {}, {}, nullptr, std::vector<PinnedLabel>{{400, 0}}),
      PreconditionError);
  CHECK_THROWS_AS(
      fit_template(part_template, shape.samples, {}, {}, nullptr, std::vector<PinnedLabel>{{0, 100}}),
      PreconditionError);
}

TEST_CASE("pins that say what the fit finds anyway change nothing") {
  const test::MadeShape shape = test::make_shape("chairs", {}, 1, 400);
  const PartTemplate part_template = test::template_from(shape);
  const auto free = fit_template(part_template, shape.samples, {});
  std::vector<PinnedLabel> pinned;
  for (std::uint32_t i = 0; i < shape.samples.size(); ++i) pinned.push_back({i, free->labels[i]});
  const auto fit = fit_template(part_template, shape.samples, {}, {}, nullptr, pinned);
  CHECK(fit->labels == free->labels);
}

TEST_CASE("the faces around a pinned sample have its label") {
  const test::MadeShape shape = test::make_shape("chairs", {}, 0, 400);
  const PartTemplate part_template = test::template_from(shape);
  const std::int16_t other = 1;
  const std::vector<PinnedLabel> pinned{{5, other}};
  const auto fit = fit_template(part_template, shape.samples, {}, {}, nullptr, pinned);
  const auto& mesh = shape.generated.mesh;
  // A face is labelled by the sample nearest to its centre: look at those whose nearest one is pinned.
  const auto labels = label_elements(mesh, shape.samples, part_template, *fit, {}, {}, pinned);
  for (std::size_t f = 0; f < mesh.element_count(); ++f) {
    const Vec3 centre = shape.samples.frame.to_normalised(face_centre(mesh, f));
    const auto nearest = std::ranges::min_element(shape.samples.points, {},
                                                  [&](const Vec3& p) { return (p - centre).squaredNorm(); });
    if (nearest - shape.samples.points.begin() == 5) CHECK(labels[f] == other);
  }
}
