// The catalogue of the bundled collection, and unpacking it.
#include "core/session/furniture_catalog.h"

#include <doctest/doctest.h>
#include <zip.h>

#include "core/base/error.h"
#include "core/io/file.h"
#include "core/session/zip_archive.h"
#include "tests/support/scratch_folder.h"

using namespace archetype;
using archetype::test::ScratchFolder;

namespace {

constexpr const char* catalogue = R"(# a comment
name=Some catalogue
license=CC-0
id#1=Some#chair
name#1=Oak chair
tags#1=Dining, Chair, Seat
model#1=/some/chair/chair.obj
creator#1=Jane
modelRotation#1=1 0 0 0 0 1 0 -1 0
name#2=Lamp \u20ac
model#2=/some/lamp.obj
name#3=Workbench
model#3=/some/bench.obj
name#4=Chair without a model
name#10=Oak chair
model#10=/some/../../../tmp/evil.obj
)";

void make_zip(const std::filesystem::path& path,
              const std::vector<std::pair<std::string, std::string>>& members) {
  int error = 0;
  zip_t* archive = zip_open(path.c_str(), ZIP_CREATE, &error);
  REQUIRE(archive);
  for (const auto& [name, content] : members) {
    zip_source_t* source = zip_source_buffer(archive, content.data(), content.size(), 0);
    REQUIRE(zip_file_add(archive, name.c_str(), source, 0) >= 0);
  }
  REQUIRE(zip_close(archive) == 0);
}

}  // namespace

TEST_CASE("A catalogue is read with its escapes; pieces without a model are left out") {
  const std::vector<FurniturePiece> pieces = parse_furniture_catalog(catalogue, "c");
  REQUIRE(pieces.size() == 4);
  CHECK(pieces[0].title == "Oak chair");
  CHECK(pieces[0].creator == "Jane");
  CHECK(pieces[0].licence == "CC-0");
  CHECK(pieces[0].source == "Some catalogue");
  CHECK(pieces[0].model == "some/chair/chair.obj");
  CHECK(pieces[0].rotation[5] == 1);
  CHECK(pieces[1].title == "Lamp \xe2\x82\xac");
  CHECK(is_seat(pieces[0]));
  CHECK_FALSE(is_seat(pieces[1]));
  CHECK_FALSE(is_seat(pieces[2]));
  CHECK_THROWS_AS(parse_furniture_catalog("name#1=x\nmodel#1=y\nmodelRotation#1=1 0 zero", "c"), InputError);
}

TEST_CASE("Seats are unpacked upright, with their credits, and only into the folder") {
  const ScratchFolder scratch;
  const auto furniture = scratch.path() / "furniture";
  std::filesystem::create_directories(furniture);
  const std::string chair = "mtllib x.mtl\nv 1 2 3\nvn 0 0 1\nf 1 1 1\n";
  make_zip(furniture / "a.sh3f", {{"PluginFurnitureCatalog.properties", catalogue},
                                  {"some/chair/chair.obj", chair},
                                  {"some/../../../tmp/evil.obj", "v 0 0 0\n"}});
  const auto target = scratch.path() / "target";
  CHECK(extract_seats(furniture, target, {}));
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(scratch.path()))
    files += entry.path().extension() == ".obj" && entry.path().parent_path() == target;
  CHECK(files == 2);
  const std::string turned = read_file(target / "Oak chair (chair).obj");
  CHECK(turned.find("# Oak chair, by Jane") == 0);
  CHECK(turned.find("v 1 3 -2\n") != std::string::npos);
  CHECK(turned.find("vn 0 1 0\n") != std::string::npos);
  CHECK(turned.find("f 1 1 1\n") != std::string::npos);
  const std::vector<Credit> credits = read_credits(target);
  REQUIRE(credits.size() == 2);
  CHECK(credits[0] == Credit{"Oak chair (chair)", "Oak chair", "Jane", "CC-0", "Some catalogue"});
  CHECK(read_credits(scratch.path()).empty());
  for (const char* foreign : {"{", "{\"films\": []}", "7"}) {
    scratch.write("credits.json", foreign);
    CHECK(read_credits(scratch.path()).empty());
  }
}

TEST_CASE("Without the package it is said what to install; a cancelled unpacking goes on later") {
  const ScratchFolder scratch;
  try {
    extract_seats(scratch.path() / "none", scratch.path() / "target", {});
    FAIL("expected an error");
  } catch (const FileError& error) {
    CHECK(std::string(error.what()).find("apt install sweethome3d-furniture") != std::string::npos);
  }
  make_zip(scratch.path() / "a.sh3f",
           {{"PluginFurnitureCatalog.properties", catalogue}, {"some/chair/chair.obj", "v 0 0 0\n"}});
  std::stop_source stop;
  stop.request_stop();
  JobControl cancelled;
  cancelled.stop = stop.get_token();
  CHECK_FALSE(extract_seats(scratch.path(), scratch.path() / "target", cancelled));
  CHECK(extract_seats(scratch.path(), scratch.path() / "target", {}));
}

TEST_CASE("An archive is not believed") {
  const ScratchFolder scratch;
  CHECK_THROWS_AS(ZipArchive(scratch.path() / "none.zip"), FileError);
  CHECK_THROWS_AS(ZipArchive(scratch.write("no.zip", "this is no archive at all")), InputError);
  make_zip(scratch.path() / "bomb.zip", {{"zeros", std::string(1 << 20, '\0')}});
  const ZipArchive bomb(scratch.path() / "bomb.zip");
  CHECK(bomb.read("zeros", 1 << 20).size() == 1 << 20);
  CHECK_THROWS_AS(bomb.read("zeros", 1000), InputError);
  CHECK_THROWS_AS(bomb.read("missing", 1000), InputError);
}
