// Project files that no Archetype wrote: an error that names the file, never a crash.
#include <doctest/doctest.h>

#include <fstream>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/io/project_database.h"
#include "core/io/project_schema.h"
#include "tests/io/sample_project.h"
#include "tests/support/scratch_folder.h"

using namespace archetype;
using namespace archetype::test;

namespace {

// A project, and a connection that does to it what no Archetype would.
struct HostileFile {
  ScratchFolder folder;
  std::filesystem::path path = folder.path() / "p.archetype";
  std::unique_ptr<Database> database;

  HostileFile() {
    {
      Project project = Project::create(path);
      fill_project(project);
    }
    database = std::make_unique<Database>(path, Database::Mode::open);
    database->execute("PRAGMA synchronous = OFF");  // hundreds of changes would wait for the disk
  }
};

std::vector<std::byte> blob_of(const HostileFile& file, const std::string& query) {
  Statement row(*file.database, query);
  REQUIRE(row.step());
  return row.blob(0);
}

void put_blob(const HostileFile& file, const std::string& statement, const std::vector<std::byte>& blob) {
  Statement(*file.database, statement).bind(std::span<const std::byte>(blob)).run();
}

std::string read_bytes(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TEST_CASE("SQLite files of other programs and of newer versions are refused") {
  const HostileFile file;
  SUBCASE("another program") {
    file.database->execute("PRAGMA application_id = 7");
    CHECK_THROWS_WITH_AS(Project::open(file.path), doctest::Contains("another program"), FileError);
  }
  SUBCASE("a newer version") {
    file.database->execute("PRAGMA user_version = " + std::to_string(newest_project_version() + 1));
    CHECK_THROWS_WITH_AS(Project::open(file.path), doctest::Contains("newer Archetype"), FileError);
    CHECK_THROWS_WITH_AS(Project::open_or_create(file.path), doctest::Contains("newer Archetype"), FileError);
  }
  SUBCASE("a version before the first") {
    file.database->execute("PRAGMA user_version = -3");
    CHECK_THROWS_AS(Project::open(file.path), FileError);
  }
}

TEST_CASE("a blob that is cut, longer or of another version is an error") {
  struct Place {
    std::string select, update;
  };
  const std::vector<Place> places{
      {"SELECT hash FROM shapes WHERE name = 'a'", "UPDATE shapes SET hash = ? WHERE name = 'a'"},
      {"SELECT frame FROM shapes WHERE name = 'a'", "UPDATE shapes SET frame = ? WHERE name = 'a'"},
      {"SELECT data FROM samples WHERE shape = 1", "UPDATE samples SET data = ? WHERE shape = 1"},
      {"SELECT state FROM fits WHERE shape = 1", "UPDATE fits SET state = ? WHERE shape = 1"},
      {"SELECT data FROM fits WHERE shape = 1", "UPDATE fits SET data = ? WHERE shape = 1"},
      {"SELECT data FROM labels WHERE shape = 1", "UPDATE labels SET data = ? WHERE shape = 1"},
      {"SELECT pixels FROM thumbnails WHERE shape = 1", "UPDATE thumbnails SET pixels = ? WHERE shape = 1"},
  };
  const HostileFile file;
  for (const Place& place : places) {
    CAPTURE(place.select);
    const std::vector<std::byte> good = blob_of(file, place.select);
    const auto check_bad = [&](const std::vector<std::byte>& bad) {
      put_blob(file, place.update, bad);
      CHECK_THROWS_AS(read_whole_project(Project::open(file.path)), FileError);
    };
    check_bad({});
    check_bad({good.begin(), good.end() - 1});
    check_bad({good.begin(), good.begin() + static_cast<std::ptrdiff_t>(good.size() / 2)});
    std::vector<std::byte> longer = good;
    longer.push_back(std::byte{0});
    check_bad(longer);
    if (place.select.find("pixels") == std::string::npos) {
      std::vector<std::byte> other_version = good;
      other_version[0] = std::byte{2};
      check_bad(other_version);
    }
    put_blob(file, place.update, good);
    CHECK_NOTHROW(read_whole_project(Project::open(file.path)));
  }
}

TEST_CASE("blobs of random bytes never do more than fail") {
  const HostileFile file;
  RandomStream random(5);
  int failures = 0;
  for (const std::string table : {"samples", "fits", "labels"}) {
    const std::string update = "UPDATE " + table + " SET data = ? WHERE shape = 1";
    const std::vector<std::byte> good = blob_of(file, "SELECT data FROM " + table + " WHERE shape = 1");
    for (int round = 0; round < 100; ++round) {
      std::vector<std::byte> bad = good;
      for (int i = 0; i < 4; ++i) {
        bad[static_cast<std::size_t>(random.below(bad.size()))] = static_cast<std::byte>(random.below(256));
      }
      put_blob(file, update, bad);
      try {
        read_whole_project(Project::open(file.path));
      } catch (const FileError&) {
        ++failures;
      }
    }
    put_blob(file, update, good);
  }
  CHECK(failures > 50);
}

TEST_CASE("values that cannot be are errors") {
  for (const char* change : {
           "UPDATE shapes SET up = 'w'",
           "UPDATE shapes SET element_count = -1",
           "UPDATE shapes SET element_count = 9223372036854775807",
           "UPDATE shapes SET element_count = 2",
           "UPDATE shapes SET sample_count = 4",
           "UPDATE shapes SET radius = 0",
           "UPDATE shapes SET radius = 9e999",
           "UPDATE fits SET status = 'great'",
           "UPDATE fits SET yaw_quarters = 4",
           "UPDATE templates SET part_count = 1",
           "UPDATE templates SET json = '{'",
           "UPDATE templates SET json = '[[[[[[[['",
           "UPDATE templates SET iteration = -1",
           "UPDATE thumbnails SET width = 100000, height = 100000",
           "UPDATE thumbnails SET width = -2, height = -1",
           "UPDATE corrections SET json = '['",
           "UPDATE corrections SET json = '7'",
           "UPDATE corrections SET json = '{\"yaw\":4}'",
           "UPDATE corrections SET json = '{\"yaw\":-1}'",
           "UPDATE corrections SET json = '{\"yaw\":\"left\"}'",
           "UPDATE corrections SET json = '{\"template\":1}'",
           "UPDATE corrections SET json = '{\"mark\":\"great\"}'",
           "UPDATE corrections SET json = '{\"pinned\":[1]}'",
           "UPDATE corrections SET json = '{\"pinned\":{\"a\":[]}}'",
           "UPDATE corrections SET json = '{\"pinned\":{\"a\":[2,1]}}'",
           "UPDATE corrections SET json = '{\"pinned\":{\"a\":[1,1]}}'",
           "UPDATE corrections SET json = '{\"pinned\":{\"a\":[1],\"b\":[1]}}'",
           "UPDATE corrections SET json = '{\"pinned\":{\"a\":[1000000]}}'",
           "UPDATE corrections SET json = '{\"pinned\":{\"a\":[1.5]}}'",
           "UPDATE corrections SET json = '{\"pinned\":{\"a\":[[[[[[1]]]]]]}}'",
           "UPDATE corrections SET json = '{\"sampling\":\"0\"}'",
           "UPDATE corrections SET json = '{\"sampling\":\"0000000000000000000000000000000g\"}'",
           "DELETE FROM samples",
           "DROP TABLE labels",
           "ALTER TABLE fits DROP COLUMN data",
       }) {
    CAPTURE(change);
    const HostileFile file;
    file.database->execute(change);
    CHECK_THROWS_WITH_AS(read_whole_project(Project::open(file.path)), doctest::Contains("p.archetype"),
                         FileError);
  }
}

TEST_CASE("a trigger in a stranger's file does not run") {
  const HostileFile file;
  file.database->execute("CREATE TRIGGER evil AFTER INSERT ON settings BEGIN DELETE FROM fits; END");
  Project project = Project::open(file.path);
  project.set_setting("a", "b");
  CHECK(project.fits().size() == 2);
}

TEST_CASE("a damaged database file never does more than fail") {
  HostileFile file;
  file.database.reset();
  const std::string good = read_bytes(file.path);
  RandomStream random(9);
  int failures = 0;
  for (int round = 0; round < 150; ++round) {
    std::string bad = good;
    for (int i = 0; i < 8; ++i) bad[random.below(bad.size())] = static_cast<char>(random.below(256));
    if (round % 5 == 0) bad.resize(random.below(bad.size()));
    const auto path = file.folder.write("bad.archetype", bad);
    try {
      Project project = Project::open(path);
      read_whole_project(project);
      fill_project(project);
    } catch (const FileError&) {
      ++failures;
    }
  }
  CHECK(failures > 20);
}
