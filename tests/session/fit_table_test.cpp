#include "core/session/fit_table.h"

#include <doctest/doctest.h>

#include "core/session/fit_collection.h"
#include "core/session/import_shapes.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/small_collection.h"

using namespace archetype;
using namespace archetype::test;

TEST_CASE("the table of fits holds what each fit says, in the order of the shapes") {
  ScratchFolder folder;
  Project project = Project::in_memory();
  write_chairs(folder.path(), 5);
  ImportOptions options;
  options.points = 150;
  import_shapes(project, {folder.path() / "shapes"}, options, {});
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
