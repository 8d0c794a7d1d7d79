// What was corrected by hand is kept with the project, in newer files and in older ones once they are opened.
#include <doctest/doctest.h>

#include <filesystem>

#include "core/io/project_database.h"
#include "core/io/project_schema.h"
#include "tests/io/sample_project.h"
#include "tests/support/scratch_folder.h"

using namespace archetype;
using namespace archetype::test;

namespace {

Corrections of_shape(ShapeId shape, const ShapeCorrection& correction) {
  return {{shape, std::make_shared<const ShapeCorrection>(correction)}};
}

// A project as version 1 wrote it.
std::filesystem::path write_version_1(const ScratchFolder& folder) {
  const auto path = folder.path() / "old.archetype";
  {
    Project project = Project::create(path);
    fill_project(project);
  }
  Database database(path, Database::Mode::open);
  database.execute("DROP TABLE corrections");
  database.execute("PRAGMA user_version = 1");
  return path;
}

}  // namespace

TEST_CASE("corrections are there when a project is opened again, exactly those that were set last") {
  const ScratchFolder folder;
  const auto path = folder.path() / "p.archetype";
  ShapeId a = 0;
  ShapeId b = 0;
  {
    Project project = Project::create(path);
    CHECK(project.corrections().empty());
    fill_project(project);
    a = project.find_shape("a")->id;
    b = project.find_shape("b")->id;
  }
  Project project = Project::open(path);
  REQUIRE(project.corrections().size() == 1);
  CHECK(*project.corrections().at(a) == sample_correction());

  ShapeCorrection marked;
  marked.mark = ShapeMark::outlier;
  project.set_corrections(of_shape(b, marked));
  REQUIRE(project.corrections().size() == 1);
  CHECK(*project.corrections().at(b) == marked);
  project.set_corrections(of_shape(b, {}));  // says nothing
  CHECK(project.corrections().empty());
  project.set_corrections(of_shape(12345, marked));  // a shape that is not there
  CHECK(project.corrections().empty());
}

TEST_CASE("a copy of a project has its corrections; a shape that is read again keeps its own") {
  const ScratchFolder folder;
  Project project = Project::create(folder.path() / "p.archetype");
  fill_project(project);
  project.copy_to(folder.path() / "copy.archetype");
  CHECK(Project::open(folder.path() / "copy.archetype").corrections().size() == 1);
  ShapeRecord again = sample_record("a");
  again.hash.words[0] = 4;
  const ShapeId id = project.add_shape(again, sample_samples());
  CHECK(project.corrections().at(id)->yaw_quarters == 3);
  CHECK(project.corrections().at(id)->sampling != sampling_of(again));  // what was painted is void
}

TEST_CASE("how a shape was sampled decides what pinned points mean") {
  const ContentHash before = sampling_of(sample_record("a"));
  ShapeRecord record = sample_record("a");
  record.path = "/elsewhere/a.off";
  CHECK(sampling_of(record) == before);
  for (const auto change :
       {+[](ShapeRecord& r) { r.hash.words[1] ^= 1; }, +[](ShapeRecord& r) { r.up = UpAxis::y; },
        +[](ShapeRecord& r) { r.requested_points = 501; }, +[](ShapeRecord& r) { ++r.seed; }}) {
    record = sample_record("a");
    change(record);
    CHECK(sampling_of(record) != before);
  }
}

TEST_CASE("an older project gets the table for corrections when it is opened, and keeps all else") {
  const ScratchFolder folder;
  const auto path = write_version_1(folder);
  Project project = Project::open(path);
  read_whole_project(project);
  CHECK(project.corrections().empty());
  CHECK(project.fits().size() == 2);
  const ShapeId a = project.find_shape("a")->id;
  project.set_corrections(of_shape(a, sample_correction()));
  CHECK(*Project::open(path).corrections().at(a) == sample_correction());
  CHECK(Database(path, Database::Mode::open).number("PRAGMA user_version") == newest_project_version());
}

TEST_CASE("an older project on a medium where nothing can be written is read without corrections") {
  const ScratchFolder folder;
  const auto path = write_version_1(folder);
  {
    Database database(path, Database::Mode::open);
    database.execute("PRAGMA journal_mode = DELETE");
  }
  Database database(path, Database::Mode::read);
  check_and_migrate_schema(database);
  CHECK(database.number("PRAGMA user_version") == 1);
}
