#include "core/session/coaligned_cloud.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "core/session/fit_collection.h"
#include "core/session/import_shapes.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/small_collection.h"

using namespace archetype;
using namespace archetype::test;

namespace {

Project fitted_chairs(std::size_t count) {
  const ScratchFolder folder;
  Project project = Project::in_memory();
  write_chairs(folder.path(), count);
  ImportOptions options;
  options.points = 200;
  import_shapes(project, {folder.path() / "shapes"}, options, {});
  fit_collection(project, {chair_template()}, {}, 2, {});
  return project;
}

}  // namespace

TEST_CASE("a cloud holds every sample of every fitted shape once, where coalign puts it") {
  const Project project = fitted_chairs(4);
  const std::vector<ShapeId> ids = project.shape_ids();
  const auto cloud = read_coaligned_cloud(project, {ids}, {});
  REQUIRE(cloud);
  CHECK(cloud->shapes.size() == 4);
  CHECK(cloud->templates.size() == 1);
  CHECK(cloud->samples == cloud->points.size());
  CHECK(cloud->rigid.size() == cloud->points.size());
  CHECK(cloud->deformed.size() == cloud->points.size());
  CHECK(cloud->normals.size() == cloud->points.size());
  CHECK(cloud->sharpness.mean_deformed() < cloud->sharpness.mean_rigid());

  const FitRecord fit = *project.fit(ids[2]);
  const ShapeSamples samples = project.samples(ids[2]);
  const std::vector<Vec3> canonical = coalign(chair_template(), samples, fit.fit);
  std::size_t found = 0;
  for (std::size_t i = 0; i < cloud->points.size(); ++i) {
    if (cloud->shapes[cloud->points[i].shape].id != ids[2]) continue;
    ++found;
    const auto same = std::ranges::find_if(
        canonical, [&](const Vec3& p) { return (p.cast<float>() - cloud->deformed[i]).norm() < 1e-6F; });
    CHECK(same != canonical.end());
  }
  CHECK(found == samples.size());
  // Mixed: the first quarter has points of all shapes.
  std::vector<bool> seen(4);
  for (std::size_t i = 0; i < cloud->points.size() / 4; ++i) seen[cloud->points[i].shape] = true;
  CHECK(std::ranges::count(seen, true) == 4);
}

TEST_CASE("a cloud is bounded, the same for any number of threads, and leaves out what is not fitted") {
  Project project = fitted_chairs(3);
  const std::vector<ShapeId> ids = project.shape_ids();
  CloudRequest request{ids, 150, 1};
  const auto one = read_coaligned_cloud(project, request, {});
  request.threads = 3;
  const auto three = read_coaligned_cloud(project, request, {});
  REQUIRE(one);
  CHECK(one->points.size() == 150);
  CHECK(one->samples > 500);
  CHECK(one->sharpness.samples > 400);  // of all samples
  CHECK(one->deformed == three->deformed);
  project.clear_fits();
  const auto none = read_coaligned_cloud(project, request, {});
  REQUIRE(none);
  CHECK(none->points.empty());
  CHECK(read_coaligned_cloud(project, {}, {})->shapes.empty());
  CHECK(read_coaligned_cloud(project, {{12345}}, {})->shapes.empty());
  std::stop_source stop;
  stop.request_stop();
  JobControl control;
  control.stop = stop.get_token();
  CHECK_FALSE(read_coaligned_cloud(project, request, control));
}
