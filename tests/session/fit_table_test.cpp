#include "core/session/fit_table.h"

#include <doctest/doctest.h>

#include "core/base/hash.h"
#include "core/session/fit_collection.h"
#include "core/session/import_shapes.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/small_collection.h"

using namespace archetype;
using namespace archetype::test;

namespace {

Project five_chairs(const ScratchFolder& folder) {
  Project project = Project::in_memory();
  write_chairs(folder.path(), 5);
  ImportOptions options;
  options.points = 150;
  import_shapes(project, {folder.path() / "shapes"}, options, {});
  return project;
}

}  // namespace

TEST_CASE("the table of fits holds what each fit says, in the order of the shapes") {
  ScratchFolder folder;
  Project project = five_chairs(folder);
  CHECK(read_fit_table(project, {})->rows.empty());

  fit_collection(project, {chair_template()}, {}, 2, {});
  // A template that is no longer in use, but that a fit still has.
  const std::vector<ShapeId> shapes = project.shape_ids();
  FitRecord older = *project.fit(shapes[3]);
  TemplateRecord other;
  other.part_template = chair_template();
  other.part_template.name = "older";
  other.part_template.parts.pop_back();
  other.current = false;
  older.part_template = project.add_template(other);
  older.fit.parts.pop_back();
  for (std::int16_t& label : older.fit.labels) label = 0;
  project.store_fit(older);

  const std::optional<FitTable> table = read_fit_table(project, {});
  REQUIRE(table);
  REQUIRE(table->templates.size() == 2);
  CHECK(table->templates[1].part_template.name == "older");
  REQUIRE(table->rows.size() == 5);
  for (std::size_t i = 0; i < 5; ++i) {
    const FitTableRow& row = table->rows[i];
    CHECK(row.summary.shape == shapes[i]);
    CHECK(row.part_template == (i == 3 ? 1 : 0));
    const FitRecord record = *project.fit(shapes[i]);
    CHECK(row.translation == record.fit.translation);
    REQUIRE(table->parts_of(row).size() == record.fit.parts.size());
    double share = 0;
    for (std::size_t p = 0; p < record.fit.parts.size(); ++p) {
      const PartValues& part = table->parts_of(row)[p];
      CHECK(part.present == record.fit.parts[p].present);
      CHECK(part.box.centre == record.fit.parts[p].box.centre);
      share += part.share;
    }
    CHECK(share <= doctest::Approx(1));
    CHECK(share > 0.5);
  }
  CHECK(table->parts_of(table->rows[3])[0].share == 1);
}

TEST_CASE("a table read after another one is the same as one that is read anew") {
  ScratchFolder folder;
  Project project = five_chairs(folder);
  fit_collection(project, {chair_template()}, {}, 2, {});
  const FitTable before = *read_fit_table(project, {});
  const std::vector<ShapeId> shapes = project.shape_ids();
  project.set_fit_status(shapes[0], FitStatus::outlier);
  PartTemplate moved = chair_template();
  moved.name = "moved";
  moved.parts[0].position.mean.y() += 0.1;
  TemplateRecord other;
  other.part_template = moved;
  FitRecord changed = *project.fit(shapes[1]);
  changed.part_template = project.add_template(other);
  changed.fit.parts[0].box.centre.y() += 0.1;
  project.store_fit(changed);
  FitRecord corrected = *project.fit(shapes[2]);
  corrected.state = hash_content({});
  corrected.fit.translation.x() += 0.5;
  project.store_fit(corrected);

  const FitTable anew = *read_fit_table(project, {});
  const FitTable after = *read_fit_table(project, {}, &before);
  REQUIRE(after.rows.size() == anew.rows.size());
  REQUIRE(after.templates.size() == anew.templates.size());
  CHECK(after.rows[0].summary.status == FitStatus::outlier);
  CHECK(after.rows[2].translation == corrected.fit.translation);
  for (std::size_t i = 0; i < anew.rows.size(); ++i) {
    CAPTURE(i);
    CHECK(after.rows[i].part_template == anew.rows[i].part_template);
    CHECK(after.rows[i].translation == anew.rows[i].translation);
    const auto parts = after.parts_of(after.rows[i]);
    const auto expected = anew.parts_of(anew.rows[i]);
    REQUIRE(parts.size() == expected.size());
    for (std::size_t p = 0; p < parts.size(); ++p) {
      CHECK(parts[p].present == expected[p].present);
      CHECK(parts[p].share == expected[p].share);
      CHECK(parts[p].box.centre == expected[p].box.centre);
    }
  }
}

TEST_CASE("reading the table of fits can be cancelled") {
  ScratchFolder folder;
  Project project = Project::in_memory();
  write_chairs(folder.path(), 1);
  import_shapes(project, {folder.path() / "shapes"}, {}, {});
  fit_collection(project, {chair_template()}, {}, 1, {});
  std::stop_source stop;
  stop.request_stop();
  JobControl control;
  control.stop = stop.get_token();
  CHECK_FALSE(read_fit_table(project, control));
}
