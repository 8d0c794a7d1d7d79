// How learning grows with the collection, and where ground truth is looked for.
#include "core/session/measure_subsets.h"

#include <doctest/doctest.h>

#include "core/session/ground_truth.h"
#include "core/session/import_shapes.h"
#include "core/session/measure_starts.h"
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
  const auto measures = measure_subsets(project, {chair_template()}, {2, 4}, {}, 1, 2, {});
  REQUIRE(measures);
  REQUIRE(measures->size() == 2);
  CHECK((*measures)[0].shapes == 2);
  CHECK((*measures)[1].shapes == 4);
  CHECK((*measures)[1].templates >= 1);
  CHECK((*measures)[0].learning_seconds > 0);
  CHECK((*measures)[1].judging == 0);
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
  CHECK_FALSE(measure_subsets(project, {chair_template()}, {2}, {}, 1, 1, control));
}

TEST_CASE("with ground truth a quarter of the shapes is kept apart to judge what is learned") {
  const ScratchFolder folder;
  Project project = chairs(folder, least_shapes_to_judge);
  const GroundTruthFolders truth{.labels = folder.path() / "labels", .landmarks = {}};
  const auto measures = measure_subsets(project, {chair_template()}, {4, 8, 12}, truth, 1, 2, {});
  REQUIRE(measures);
  REQUIRE(measures->size() == 3);
  CHECK(measures->back().shapes == least_shapes_to_judge - 3);
  for (const SubsetMeasure& each : *measures) {
    CHECK(each.judging == 3);
    REQUIRE(each.accuracy.labelling);
    CHECK(*each.accuracy.labelling > 0.5);
    CHECK_FALSE(each.accuracy.correspondence);
  }
  store_subset_measures(project, *measures);
  CHECK(stored_subset_measures(project) == *measures);
  // As earlier versions stored them.
  project.set_setting("report.subsets", "8 1 0.5 0.25\n16 2 0.75 0.5\n");
  CHECK(stored_subset_measures(project) == std::vector<SubsetMeasure>{{8, 1, 0.5, 0.25}, {16, 2, 0.75, 0.5}});
}

TEST_CASE("learning from several starts ends with less energy than each began with, and is kept") {
  const ScratchFolder folder;
  Project project = chairs(folder, 4);
  const GroundTruthFolders truth{.labels = folder.path() / "labels", .landmarks = {}};
  PartTemplate off = chair_template();
  off.name = "off";
  for (TemplatePart& part : off.parts) part.position.mean.y() += 0.15;
  const auto measures = measure_starts(project, {chair_template(), off}, truth, 1, 2, {});
  REQUIRE(measures);
  REQUIRE(measures->size() == 2);
  for (const StartMeasure& each : *measures) {
    CHECK(each.energy_after < each.energy_before);
    CHECK_FALSE(each.learned.empty());
    CHECK(each.after.best_labelling);
  }
  CHECK((*measures)[1].initial == off);
  CHECK(project.fits().empty());
  CHECK(project.templates().empty());
  store_start_measures(project, *measures);
  CHECK(stored_start_measures(project) == *measures);
  for (const char* broken : {"{", "[{}]", "[{\"initial\": 3}]", "7"}) {
    CAPTURE(broken);
    project.set_setting("report.starts", broken);
    CHECK(stored_start_measures(project).empty());
  }
}

TEST_CASE("ground truth that is stored beside what was measured comes back whatever its name") {
  const GroundTruthFolders truth{.labels = "/a folder/with \"quotes\"\nand lines", .landmarks = {}};
  CHECK(to_text(truth).find('\n') == std::string::npos);
  CHECK(ground_truth_from(to_text(truth)) == truth);
  CHECK(ground_truth_from(to_text({.labels = "/\xff", .landmarks = "/b"})).landmarks == "/b");
  for (const char* broken : {"", "[", "[\"/a\"]", "[1, 2]", "{}"})
    CHECK(ground_truth_from(broken) == GroundTruthFolders{});
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
