#include "core/evaluation/label_elements.h"

#include <doctest/doctest.h>

#include "core/base/error.h"
#include "core/fitting/fit_template.h"
#include "tests/support/made_shapes.h"

using namespace archetype;
using namespace archetype::test;

namespace {

struct Fitted {
  MadeShape shape;
  PartTemplate part_template;
  ShapeFit fit;

  explicit Fitted(const GenerateOptions& options, std::size_t index = 3)
      : shape(make_shape("chairs", options, index)), part_template(template_from(shape)) {
    fit = fit_template(part_template, shape.samples, {}).value();
  }
};

}  // namespace

TEST_CASE("faces of a surface and of a soup get their parts, one label a face") {
  GenerateOptions options;
  SUBCASE("surface") {}
  SUBCASE("soup: no two faces share a vertex") {
    options.faults.flipped = 0.3;
    options.faults.duplicate = 0.3;
  }
  Fitted fitted(options);
  PolygonMesh& mesh = fitted.shape.generated.mesh;
  if (options.faults.flipped > 0) {
    PolygonMesh soup;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
      std::vector<std::uint32_t> corners;
      for (const auto corner : mesh.face(f)) {
        corners.push_back(static_cast<std::uint32_t>(soup.vertices.size()));
        // A hair apart, so that corners are not the same point either.
        soup.vertices.push_back(mesh.vertices[corner] + 1e-4 * static_cast<double>(f) * Vec3::UnitX());
      }
      soup.add_face(corners);
    }
    mesh = std::move(soup);
  }
  const auto labels =
      label_elements(mesh, fitted.shape.samples, fitted.part_template, fitted.fit, FitOptions{});
  CHECK(labels.size() == mesh.face_count());
  CHECK(label_accuracy(fitted.shape, fitted.part_template, labels) > 0.9);
}

TEST_CASE("a fit without parts labels nothing; a foreign one is a mistake of the caller") {
  Fitted fitted({});
  const PolygonMesh& mesh = fitted.shape.generated.mesh;
  ShapeFit nothing = fitted.fit;
  nothing.labels.assign(nothing.labels.size(), null_label);
  const ElementLabeller labeller(mesh, fitted.shape.samples, {});
  for (const auto label : labeller.label(fitted.part_template, nothing)) CHECK(label == null_label);
  nothing.labels.pop_back();
  CHECK_THROWS_AS(labeller.label(fitted.part_template, nothing), PreconditionError);
  PolygonMesh other;
  other.vertices.assign(3, Vec3::Zero());
  other.add_face(std::array{0U, 1U, 2U});
  CHECK_THROWS_AS(ElementLabeller(other, fitted.shape.samples, {}), PreconditionError);
}

TEST_CASE("labelling that is cancelled gives nothing, and soon") {
  const test::MadeShape shape = test::make_shape("chairs", {}, 1);
  const PartTemplate part_template = test::template_from(shape);
  const FitOptions options;
  const ShapeFit fit = *fit_template(part_template, shape.samples, options);
  std::stop_source source;
  JobControl control;
  control.stop = source.get_token();
  const ElementLabeller labeller(shape.generated.mesh, shape.samples, options, control);
  CHECK_FALSE(labeller.label(part_template, fit, control).empty());
  source.request_stop();
  CHECK(labeller.label(part_template, fit, control).empty());
  CHECK(label_elements(shape.generated.mesh, shape.samples, part_template, fit, options, control).empty());
}
