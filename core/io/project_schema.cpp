// The tables of a project file. Version n is what the first n migrations make of an empty database, so that a
// new project and a migrated one cannot differ. A released migration never changes; a new version appends
// one.
#include "core/io/project_schema.h"

#include <array>

#include "core/base/error.h"

namespace archetype {

namespace {

// Samples and other bulk stand apart from the tables that lists are drawn from, so that those stay small.
constexpr const char* version_1 = R"sql(
CREATE TABLE shapes (
  id INTEGER PRIMARY KEY,
  name TEXT NOT NULL UNIQUE,
  path BLOB NOT NULL,
  hash BLOB NOT NULL,
  up TEXT NOT NULL,
  vertex_count INTEGER NOT NULL,
  element_count INTEGER NOT NULL,
  point_set INTEGER NOT NULL,
  frame BLOB NOT NULL,
  radius REAL NOT NULL,
  sample_count INTEGER NOT NULL,
  requested_points INTEGER NOT NULL,
  seed INTEGER NOT NULL,
  up_decided INTEGER NOT NULL
) STRICT;
CREATE TABLE samples (
  shape INTEGER PRIMARY KEY REFERENCES shapes(id) ON DELETE CASCADE,
  data BLOB NOT NULL
) STRICT;
CREATE TABLE refused (
  path BLOB PRIMARY KEY,
  reason TEXT NOT NULL
) STRICT;
CREATE TABLE templates (
  id INTEGER PRIMARY KEY AUTOINCREMENT,
  json TEXT NOT NULL,
  part_count INTEGER NOT NULL,
  iteration INTEGER NOT NULL,
  parent INTEGER,
  position INTEGER
) STRICT;
CREATE TABLE fits (
  shape INTEGER PRIMARY KEY REFERENCES shapes(id) ON DELETE CASCADE,
  template INTEGER NOT NULL REFERENCES templates(id),
  status TEXT NOT NULL,
  state BLOB NOT NULL,
  yaw_quarters INTEGER NOT NULL,
  shape_to_template REAL NOT NULL,
  template_to_shape REAL NOT NULL,
  features REAL NOT NULL,
  deformation REAL NOT NULL,
  smoothness REAL NOT NULL,
  existence REAL NOT NULL,
  data BLOB NOT NULL
) STRICT;
CREATE TABLE labels (
  shape INTEGER PRIMARY KEY REFERENCES fits(shape) ON DELETE CASCADE,
  data BLOB NOT NULL
) STRICT;
CREATE TABLE thumbnails (
  shape INTEGER NOT NULL REFERENCES shapes(id) ON DELETE CASCADE,
  kind TEXT NOT NULL,
  width INTEGER NOT NULL,
  height INTEGER NOT NULL,
  pixels BLOB NOT NULL,
  PRIMARY KEY (shape, kind)
) STRICT;
CREATE TABLE settings (
  key TEXT PRIMARY KEY,
  value TEXT NOT NULL
) STRICT;
)sql";

// What was corrected by hand.
constexpr const char* version_2 = R"sql(
CREATE TABLE corrections (
  shape INTEGER PRIMARY KEY REFERENCES shapes(id) ON DELETE CASCADE,
  json TEXT NOT NULL
) STRICT;
)sql";

constexpr std::array<const char*, 2> migrations{version_1, version_2};

void migrate(Database& database, std::int64_t from) {
  WriteScope scope(database);
  for (auto version = static_cast<std::size_t>(from); version < migrations.size(); ++version) {
    database.execute(migrations[version]);
  }
  database.execute("PRAGMA application_id = " + std::to_string(project_application_id));
  database.execute("PRAGMA user_version = " + std::to_string(migrations.size()));
  scope.commit();
}

}  // namespace

std::int64_t newest_project_version() {
  return migrations.size();
}

void create_schema(Database& database) {
  migrate(database, 0);
}

void check_and_migrate_schema(Database& database) {
  const std::int64_t application = database.number("PRAGMA application_id");
  const std::int64_t version = database.number("PRAGMA user_version");
  if (application != project_application_id) {
    throw FileError(database.path(),
                    "is an SQLite file of another program, not an Archetype project; choose another file");
  }
  if (version > newest_project_version()) {
    throw FileError(database.path(), "was written by a newer Archetype (project version " +
                                         std::to_string(version) + "; this program knows up to " +
                                         std::to_string(newest_project_version()) +
                                         "); open it with that version or a later one");
  }
  if (version < 1) throw FileError(database.path(), "has no valid project version; restore it from a copy");
  if (version < newest_project_version() && database.writable()) migrate(database, version);
}

}  // namespace archetype
