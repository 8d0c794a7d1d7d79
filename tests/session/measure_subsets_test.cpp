// How learning grows with the collection, and where ground truth is looked for.
#include "core/session/measure_subsets.h"

#include <doctest/doctest.h>

#include "core/session/ground_truth.h"
#include "core/session/import_shapes.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/small_collection.h"

using namespace archetype;
using namespace archetype::test;

namespace {

Project chairs(const ScratchFolder& folder, std::size_t count) {
  Project project = Project::in_memory();
  write_chairs(folder.path(), count);
  ImportOptions options;
  options.points = 100;
  import_shapes(project, {folder.path() / "shapes"}, options, {});
  return project;
}

}  // namespace

TEST_CASE("subsets double up to the whole collection, or a thousand") {
  CHECK(subset_sizes(0).empty());
  CHECK(subset_sizes(1) == std::vector<std::size_t>{1});
  CHECK(subset_sizes(20) == std::vector<std::size_t>{8, 20});
  CHECK(subset_sizes(96) == std::vector<std::size_t>{8, 16, 32, 64, 96});
  CHECK(subset_sizes(10'000).back() == 1000);
}

TEST_CASE("learning from subsets leaves the project alone; the numbers are kept") {
  const ScratchFolder folder;
  Project project = chairs(folder, 4);
  const auto measures = measure_subsets(project, {chair_template()}, {2, 4}, 1, 2, {});
  REQUIRE(measures);
  REQUIRE(measures->size() == 2);
  CHECK((*measures)[0].shapes == 2);
  CHECK((*measures)[1].shapes == 4);
  CHECK((*measures)[1].templates >= 1);
  CHECK((*measures)[0].learning_seconds > 0);
  CHECK(project.fits().empty());
  CHECK(project.templates().empty());
  CHECK(stored_subset_measures(project).empty());
  store_subset_measures(project, *measures);
  CHECK(stored_subset_measures(project) == *measures);
  project.set_setting("report.subsets", "3 1 0.5 nonsense");
  CHECK(stored_subset_measures(project).empty());

  std::stop_source stop;
  stop.request_stop();
  JobControl control;
  control.stop = stop.get_token();
  CHECK_FALSE(measure_subsets(project, {chair_template()}, {2}, 1, 1, control));
}

TEST_CASE("ground truth is found beside the shapes, and remembered where it was chosen") {
  const ScratchFolder folder;
  Project project = chairs(folder, 1);
  CHECK(ground_truth_folders(project).labels == folder.path() / "labels");
  remember_ground_truth(project, {.labels = "/elsewhere", .landmarks = {}});
  CHECK(ground_truth_folders(project).labels == "/elsewhere");
  CHECK(ground_truth_folders(project).landmarks == folder.path() / "landmarks");
  CHECK(ground_truth_folders(Project::in_memory()) == GroundTruthFolders{});
}
