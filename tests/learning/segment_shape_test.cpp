#include "core/learning/segment_shape.h"

#include <doctest/doctest.h>

#include "core/base/error.h"
#include "core/generate/solids.h"
#include "core/geometry/sample_shape.h"
#include "core/learning/mirror_symmetry.h"

using namespace archetype;

namespace {

// A flat plate with a post standing on it.
ShapeSamples plate_and_post() {
  Assembly assembly;
  add_block(assembly, 0, {1, 0.1, 1}, 0.01, {4, 1, 4}, at({0, 0, 0}));
  add_block(assembly, 1, {0.15, 0.8, 0.15}, 0.01, {1, 4, 1}, at({0, 0.9, 0}));
  SamplingOptions options;
  options.points = 600;
  return sample_shape(assembly.mesh, {{1, 2}}, options);
}

}  // namespace

TEST_CASE("a plate with a post is segmented into plate and post, whatever the seed") {
  const ShapeSamples samples = plate_and_post();
  const double scale = samples.frame.scale;
  const Box plate{samples.frame.to_normalised({0, 0, 0}), scale * Vec3(1, 0.1, 1)};
  const Box post{samples.frame.to_normalised({0, 0.9, 0}), scale * Vec3(0.15, 0.8, 0.15)};
  for (const std::uint64_t seed : {1, 2, 3}) {
    SegmentationOptions options;
    options.seed = seed;
    const std::optional<Segmentation> found = segment_shape(samples, options);
    REQUIRE(found);
    REQUIRE(found->boxes.size() == 2);
    CHECK(box_distance(found->boxes[0], plate) < 0.15);
    CHECK(box_distance(found->boxes[1], post) < 0.15);
    CHECK(found->labels.size() == samples.size());
  }
}

TEST_CASE("a drum is a cylinder where parts may be round") {
  Assembly assembly;
  add_turned(assembly, 0, Vec3::Zero(), Vec3::UnitY(), {{0.001, -1}, {1, -1}, {1, 1}, {0.001, 1}}, 48);
  add_block(assembly, 1, {0.15, 0.8, 0.15}, 0.01, {1, 4, 1}, at({0, 1.8, 0}));
  SamplingOptions sampling;
  sampling.points = 600;
  const ShapeSamples samples = sample_shape(assembly.mesh, {{1, 2}}, sampling);
  SegmentationOptions options;
  const std::optional<Segmentation> straight = segment_shape(samples, options);
  REQUIRE(straight);
  for (const Box& box : straight->boxes) CHECK(box.solid == Solid::box);
  options.solids = RegionSolids::any;
  const std::optional<Segmentation> found = segment_shape(samples, options);
  REQUIRE(found);
  REQUIRE(found->boxes.size() == 2);
  CHECK(found->boxes[0].solid == Solid::cylinder_y);
  const Box drum{samples.frame.to_normalised(Vec3::Zero()), samples.frame.scale * Vec3(0.886, 1, 0.886)};
  CHECK(box_distance(found->boxes[0], drum) < 0.15);
}

TEST_CASE("the number of parts stays in its range") {
  const ShapeSamples samples = plate_and_post();
  SegmentationOptions options;
  options.min_parts = 4;
  options.max_parts = 6;
  const std::size_t more = segment_shape(samples, options)->boxes.size();
  CHECK(more >= 4);
  CHECK(more <= 6);
  options.min_parts = options.max_parts = 1;
  CHECK(segment_shape(samples, options)->boxes.size() == 1);
  options.max_parts = 0;
  CHECK_THROWS_AS(segment_shape(samples, options), PreconditionError);
  CHECK_THROWS_AS(segment_shape({}, {}), PreconditionError);
}

TEST_CASE("a cancelled segmentation returns nothing") {
  std::stop_source source;
  source.request_stop();
  JobControl control;
  control.stop = source.get_token();
  CHECK_FALSE(segment_shape(plate_and_post(), {}, control));
}
