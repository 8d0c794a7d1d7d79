// What is put into a project comes out of it again, also from another connection and after a failure.
#include "core/io/project.h"

#include <doctest/doctest.h>
#include <unistd.h>

#include <atomic>
#include <ctime>
#include <latch>
#include <thread>

#include "core/base/error.h"
#include "core/io/project_database.h"
#include "tests/io/sample_project.h"
#include "tests/support/disk_limit.h"
#include "tests/support/scratch_folder.h"

using namespace archetype;
using namespace archetype::test;

namespace {

void check_equal(const ShapeSamples& a, const ShapeSamples& b) {
  CHECK(a.frame.rotation == b.frame.rotation);
  CHECK(a.frame.centroid == b.frame.centroid);
  CHECK(a.frame.scale == b.frame.scale);
  CHECK(a.radius == b.radius);
  CHECK(a.points == b.points);
  CHECK(a.normals == b.normals);
  CHECK(a.faces == b.faces);
  CHECK(a.features_x == b.features_x);
  CHECK(a.features_z == b.features_z);
}

void check_equal(const ShapeFit& a, const ShapeFit& b) {
  CHECK(a.yaw_quarters == b.yaw_quarters);
  CHECK(a.translation == b.translation);
  CHECK(a.labels == b.labels);
  CHECK(a.energy == b.energy);
  CHECK(a.alternations == b.alternations);
  CHECK(a.converged == b.converged);
  CHECK(a.yaw_energies == b.yaw_energies);
  REQUIRE(a.parts.size() == b.parts.size());
  for (std::size_t i = 0; i < a.parts.size(); ++i) {
    CHECK(a.parts[i].present == b.parts[i].present);
    CHECK(a.parts[i].box.centre == b.parts[i].box.centre);
    CHECK(a.parts[i].box.half_extent == b.parts[i].box.half_extent);
    CHECK(a.parts[i].box.solid == b.parts[i].box.solid);
    CHECK(a.parts[i].box.orientation.coeffs() == b.parts[i].box.orientation.coeffs());
  }
}

std::vector<std::string> names(const std::vector<ShapeRecord>& shapes) {
  std::vector<std::string> result;
  for (const ShapeRecord& shape : shapes) result.push_back(shape.name);
  return result;
}

}  // namespace

TEST_CASE("all that a project holds is there when it is opened again") {
  const ScratchFolder folder;
  const auto path = folder.path() / "p.archetype";
  {
    Project project = Project::create(path);
    fill_project(project);
  }
  const Project project = Project::open(path);
  CHECK(project.path() == path);
  CHECK(project.shape_count() == 2);
  CHECK(names(project.shapes()) == std::vector<std::string>{"a", "b"});
  CHECK(names(project.shapes(1, 5)) == std::vector<std::string>{"b"});
  CHECK(names(project.shapes(0, 1)) == std::vector<std::string>{"a"});

  const ShapeRecord expected = sample_record("a");
  const ShapeRecord shape = project.find_shape("a").value();
  CHECK(shape.path == expected.path);
  CHECK(shape.hash == expected.hash);
  CHECK(shape.up == expected.up);
  CHECK(shape.vertex_count == 8);
  CHECK(shape.element_count == 6);
  CHECK_FALSE(shape.point_set);
  CHECK(shape.frame.centroid == sample_samples().frame.centroid);
  CHECK(shape.radius == 2.5);
  CHECK(shape.requested_points == 500);
  CHECK(shape.seed == expected.seed);
  CHECK(project.find_shape(shape.id)->name == "a");
  CHECK_FALSE(project.find_shape("c"));
  check_equal(project.samples(shape.id), sample_samples());

  const FitRecord fit = project.fit(shape.id).value();
  CHECK(fit.status == FitStatus::outlier);
  CHECK(fit.state == ContentHash{{5, 6}});
  check_equal(fit.fit, sample_fit());
  CHECK(project.labels(shape.id).value() == std::vector<std::int16_t>{0, 1, -1, 0, 1, 1});
  CHECK(project.thumbnail(shape.id, "surface").value() == Thumbnail{2, 1, {1, 2, 3, 4, 5, 6, 7, 8}});
  CHECK_FALSE(project.thumbnail(shape.id, std::string(parts_thumbnail)));

  const std::vector<TemplateRecord> templates = project.templates();
  REQUIRE(templates.size() == 1);
  CHECK(templates[0].part_template == sample_template());
  CHECK(fit.part_template == templates[0].id);
  CHECK(project.refused().at(0).reason == "line 1: expected OFF");
  CHECK(project.setting("key") == "value");
  CHECK_FALSE(project.setting("other"));
  const std::vector<FitSummary> fits = project.fits();
  REQUIRE(fits.size() == 2);
  CHECK(fits[0].shape == shape.id);
  CHECK(fits[0].energy == sample_fit().energy);
  CHECK(fits[0].has_labels);
}

TEST_CASE("a shape that is read again keeps its id and loses what came from its old samples") {
  Project project = Project::in_memory();
  fill_project(project);
  const ShapeId id = project.find_shape("a")->id;
  CHECK(project.add_shape(sample_record("a"), sample_samples(9)) == id);
  CHECK(project.samples(id).size() == 9);
  CHECK_FALSE(project.fit(id));
  CHECK_FALSE(project.labels(id));
  CHECK_FALSE(project.thumbnail(id, "surface"));
  CHECK(project.fits().size() == 1);
}

TEST_CASE(
    "pictures of a fit go with it, and those that an earlier version drew go when they are drawn anew") {
  Project project = Project::in_memory();
  fill_project(project);
  const ShapeId a = project.find_shape("a")->id;
  const ShapeId b = project.find_shape("b")->id;
  const std::string parts(parts_thumbnail);
  const std::string mask(part_mask_thumbnail);
  const Thumbnail picture{1, 1, {1, 2, 3, 4}};
  for (const ShapeId id : {a, b})
    for (const char* old : {"parts posed", "parts mask"}) project.store_thumbnail(id, old, picture);
  project.store_thumbnail(a, mask, picture);
  project.store_thumbnail(a, parts, picture);
  CHECK_FALSE(project.thumbnail(a, "parts posed"));
  CHECK_FALSE(project.thumbnail(a, "parts mask"));
  CHECK(project.thumbnail(a, parts));
  CHECK(project.thumbnail(a, mask));
  CHECK(project.thumbnail(a, "surface"));
  CHECK(project.thumbnail(b, "parts posed"));
  project.clear_fits();
  for (const std::string& kind : {parts, mask}) CHECK_FALSE(project.thumbnail(a, kind));
  CHECK_FALSE(project.thumbnail(b, "parts posed"));
  CHECK(project.thumbnail(b, "surface"));
}

TEST_CASE("a new fit takes the labels of the old one away") {
  Project project = Project::in_memory();
  fill_project(project);
  const ShapeId id = project.find_shape("a")->id;
  project.store_fit({id, project.templates().at(0).id, FitStatus::fitted, sample_fit(), {}});
  CHECK(project.fit(id)->status == FitStatus::fitted);
  CHECK_FALSE(project.labels(id));
  project.clear_fits();
  CHECK(project.fits().empty());
  CHECK_FALSE(project.labels(project.find_shape("b")->id));
}

TEST_CASE("the current templates are those that were named, in that order; the others are history") {
  Project project = Project::in_memory();
  std::vector<TemplateId> ids;
  for (const char* name : {"x", "y", "z"}) {
    TemplateRecord record;
    record.part_template = sample_template();
    record.part_template.name = name;
    record.iteration = static_cast<int>(ids.size());
    if (!ids.empty()) record.parent = ids.back();
    ids.push_back(project.add_template(record));
  }
  CHECK(project.templates().size() == 3);
  project.set_current_templates({ids[2], ids[0]});
  const std::vector<TemplateRecord> current = project.templates();
  REQUIRE(current.size() == 2);
  CHECK(current[0].part_template.name == "z");
  CHECK(current[0].parent == ids[1]);
  CHECK(current[1].part_template.name == "x");
  CHECK_FALSE(current[1].parent);
  CHECK(project.templates(false).size() == 3);
  CHECK_FALSE(project.find_template(ids[1])->current);
}

TEST_CASE("refused inputs are replaced by path and can be forgotten; shapes can be relocated") {
  Project project = Project::in_memory();
  fill_project(project);
  project.set_refused({{"/shapes/bad.off", "empty"}, {"/shapes/a\nb", "odd"}});
  REQUIRE(project.refused().size() == 2);
  CHECK(project.refused()[1].reason == "empty");
  project.forget_refused({"/shapes/bad.off"});
  CHECK(project.refused().at(0).path == "/shapes/a\nb");
  const ShapeId id = project.find_shape("a")->id;
  project.relocate_shape(id, "/elsewhere/a.off");
  CHECK(project.find_shape(id)->path == "/elsewhere/a.off");
  CHECK(project.fit(id));
}

TEST_CASE("a transaction is all or nothing") {
  Project project = Project::in_memory();
  {
    Project::Transaction transaction(project);
    fill_project(project);
    CHECK(project.shape_count() == 2);
  }
  CHECK(project.shape_count() == 0);
  {
    Project::Transaction transaction(project);
    fill_project(project);
    transaction.commit();
  }
  CHECK(project.shape_count() == 2);
}

TEST_CASE("two connections see each other's commits") {
  const ScratchFolder folder;
  Project writer = Project::create(folder.path() / "p.archetype");
  const Project reader = Project::open(folder.path() / "p.archetype");
  fill_project(writer);
  CHECK(reader.shape_count() == 2);
}

TEST_CASE("programs that open a project in the moment after it was made do not stop each other") {
  const ScratchFolder folder;
  const std::filesystem::path path = folder.path() / "p.archetype";
  (void)Project::create(path);
  std::atomic<int> failed = 0;
  for (int round = 0; round < 50; ++round) {
    // As it is before its maker has set up the log.
    Database(path, Database::Mode::open).execute("PRAGMA journal_mode = DELETE");
    std::latch all_there(4);
    std::vector<std::jthread> programs;
    for (int k = 0; k < 4; ++k) {
      programs.emplace_back([&] {
        all_there.arrive_and_wait();
        try {
          (void)Project::open(path);
        } catch (const Error&) {
          ++failed;
        }
      });
    }
  }
  CHECK(failed == 0);
}

TEST_CASE("a full disk is an error that says so, loses nothing that was committed and does not last") {
  const ScratchFolder folder;
  const auto path = folder.path() / "p.archetype";
  Project project = Project::create(path);
  fill_project(project);
  {
    const DiskLimit limit(200'000);
    ShapeRecord record = sample_record("big");
    CHECK_THROWS_WITH_AS(project.add_shape(record, sample_samples(20'000)), doctest::Contains("disk"),
                         FileError);
    CHECK(project.shape_count() == 2);
  }
  CHECK(Project::open(path).shape_count() == 2);
  add_whole_shape(project, "c", project.templates().at(0).id);
  CHECK(Project::open(path).shape_count() == 3);
}

TEST_CASE("a project of 10,000 shapes opens at once") {
  const ScratchFolder folder;
  const auto path = folder.path() / "p.archetype";
  {
    Project project = Project::create(path);
    Project::Transaction transaction(project);
    const ShapeSamples samples = sample_samples(50);
    for (int i = 0; i < 10'000; ++i) project.add_shape(sample_record("shape " + std::to_string(i)), samples);
    transaction.commit();
  }
  // Processor time, so that a busy machine does not matter. A release build takes about 1 ms.
  const std::clock_t begin = std::clock();
  const Project project = Project::open(path);
  CHECK(project.shape_count() == 10'000);
  CHECK(project.shapes(5'000, 20).size() == 20);
  CHECK(std::clock() - begin < CLOCKS_PER_SEC / 20);
}

TEST_CASE("what is no project is refused with the reason") {
  const ScratchFolder folder;
  CHECK_THROWS_WITH_AS(Project::open(folder.path() / "none"), doctest::Contains("does not exist"), FileError);
  CHECK_THROWS_WITH_AS(Project::open(folder.path()), doctest::Contains("not a file"), FileError);
  const auto text = folder.write("text.archetype", std::string(5000, 'x'));
  CHECK_THROWS_WITH_AS(Project::open(text), doctest::Contains("not an SQLite database"), FileError);
  CHECK_THROWS_WITH_AS(Project::open_or_create(text), doctest::Contains("not an SQLite database"), FileError);
  const auto empty = folder.write("empty.archetype", "");
  CHECK_THROWS_WITH_AS(Project::open(empty), doctest::Contains("another program"), FileError);
  CHECK_THROWS_WITH_AS(Project::create(empty), doctest::Contains("exists already"), FileError);
  CHECK_THROWS_AS(Project::create(folder.path() / "no" / "folder"), FileError);
}

TEST_CASE("a project that was killed while it was created is created again") {
  const ScratchFolder folder;
  const auto blank = folder.write("blank.archetype", "");
  Project project = Project::open_or_create(blank);
  fill_project(project);
  CHECK(Project::open(blank).shape_count() == 2);
}

TEST_CASE("a project where nothing can be written can be read") {
  const ScratchFolder folder;
  const auto path = folder.path() / "50% #1?.archetype";
  Project::create(path).set_setting("key", "value");
  {
    Database database(path, Database::Mode::read);
    CHECK_FALSE(database.writable());
    CHECK(database.number("SELECT count(*) FROM settings WHERE key = 'key'") == 1);
    CHECK_THROWS_WITH_AS(database.execute("DELETE FROM settings"), doctest::Contains("cannot be written"),
                         FileError);
    CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
  }
  namespace fs = std::filesystem;
  fs::permissions(path, fs::perms::owner_read);
  fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec);
  if (::access(path.c_str(), W_OK) != 0) {  // root may write all the same
    Project project = Project::open(path);
    CHECK(project.setting("key") == "value");
    CHECK_THROWS_AS(project.set_setting("key", "other"), FileError);
  }
  fs::permissions(folder.path(), fs::perms::owner_all);
}
