// The fit that follows edits.
#include "ui/live_fit.h"

#include <doctest/doctest.h>

#include <limits>

#include "core/evaluation/label_elements.h"
#include "core/fitting/fit_template.h"
#include "tests/support/made_shapes.h"

using namespace archetype;

namespace {

struct Made {
  test::MadeShape shape = test::make_shape("tables", {}, 1);
  PartTemplate truth = test::template_from(shape);
};

LiveFitRequest request_for(const Made& made, const PartTemplate& part_template) {
  LiveFitRequest request;
  request.part_template = std::make_shared<const PartTemplate>(part_template);
  request.samples = std::make_shared<const ShapeSamples>(made.shape.samples);
  request.mesh = std::make_shared<const PolygonMesh>(made.shape.generated.mesh);
  return request;
}

// What the window shows, turned by `yaw`.
std::shared_ptr<const ViewFit> shown_at(const LiveFitRequest& request, int yaw) {
  FitOptions options;
  options.yaw_costs.fill(std::numeric_limits<double>::infinity());
  options.yaw_costs[static_cast<std::size_t>(yaw)] = 0;
  return std::make_shared<const ViewFit>(ViewFit{
      request.part_template, *fit_template(*request.part_template, *request.samples, options), {}, {}, {}});
}

}  // namespace

TEST_CASE("A box that fits at every yaw alike does not turn the shape in view") {
  const Made made;
  PartTemplate one;
  TemplatePart part;
  part.scale.mean = Vec3::Constant(0.5);
  one.parts.push_back(part);
  LiveFitRequest request = request_for(made, one);
  LiveFitter fitter;
  for (int yaw = 0; yaw < 4; ++yaw) {
    request.start = shown_at(request, yaw);
    CHECK(fitter.run(request, {})->fit->fit.yaw_quarters == yaw);
  }
}

TEST_CASE("A shape that stands wrongly in view is turned by a template that shows how it stands") {
  Made made;
  made.shape = test::make_shape("chairs", {}, 0);
  made.truth = test::template_from(made.shape);
  LiveFitRequest request = request_for(made, made.truth);
  request.start = shown_at(request, 1);
  LiveFitter fitter;
  CHECK(fitter.run(request, {})->fit->fit.yaw_quarters == 0);
}

TEST_CASE("Faces are labelled as for a fit alone, also after another shape was in view") {
  const Made made;
  Made other_made;
  other_made.shape = test::make_shape("tables", {}, 2);
  const Made& other = other_made;
  LiveFitter fitter;
  for (const Made* shown : {&made, &other, &made}) {
    const LiveFitRequest request = request_for(*shown, made.truth);
    const auto result = fitter.run(request, {});
    CHECK(result->fit->element_labels ==
          label_elements(*request.mesh, *request.samples, made.truth, result->fit->fit, request.options));
  }
}
