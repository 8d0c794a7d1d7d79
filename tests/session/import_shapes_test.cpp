#include "core/session/import_shapes.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "core/generate/generate.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/small_collection.h"

using namespace archetype;
using namespace archetype::test;

namespace fs = std::filesystem;

namespace {

// A box of this width as OFF.
std::string box_off(double width) {
  std::string off = "OFF\n8 6 0\n";
  for (int corner = 0; corner < 8; ++corner) {
    off += std::to_string((corner & 1) * width) + " " + std::to_string(corner >> 1 & 1) + " " +
           std::to_string(corner >> 2 & 1) + "\n";
  }
  return off + "4 0 1 3 2\n4 4 5 7 6\n4 0 1 5 4\n4 2 3 7 6\n4 0 2 6 4\n4 1 3 7 5\n";
}

ImportOptions few_points(unsigned threads = 2) {
  ImportOptions options;
  options.points = 60;
  options.threads = threads;
  return options;
}

std::vector<std::string> names(const Project& project) {
  std::vector<std::string> result;
  for (const ShapeRecord& shape : project.shapes()) result.push_back(shape.name);
  return result;
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("a folder is searched to its ends, and shapes are named by their path in it") {
  const ScratchFolder folder;
  folder.write("in/b.off", box_off(1));
  folder.write("in/deep/er/a.OFF", box_off(2));
  folder.write("in/notes.txt", "not a shape");
  folder.write("in/.hidden.off", "OFF");
  folder.write("in/.git/c.off", box_off(3));
  fs::create_directory_symlink(folder.path() / "in", folder.path() / "in/deep/loop");
  folder.write("elsewhere/d.off", box_off(4));
  fs::create_directory_symlink(folder.path() / "elsewhere", folder.path() / "in/linked");

  Project project = Project::in_memory();
  const ImportReport report = import_shapes(project, {folder.path() / "in"}, few_points(), {});
  CHECK(report.refused.empty());
  CHECK(report.imported == 3);
  CHECK(names(project) == Names{"b", "deep__er__a", "linked__d"});
  const ShapeRecord shape = project.find_shape("b").value();
  CHECK(shape.path == folder.path() / "in/b.off");
  CHECK(shape.element_count == 6);
  CHECK(shape.vertex_count == 8);
  CHECK(project.samples(shape.id).size() == 60);
}

TEST_CASE("what cannot be read is refused with its reason and the rest imported") {
  const ScratchFolder folder;
  folder.write("in/good.off", box_off(1));
  folder.write("in/bad.off", "OFF\n8 6 0\n1 2");
  const fs::path text = folder.write("text.txt", "text");
  Project project = Project::in_memory();
  const std::vector<fs::path> paths{folder.path() / "in", text, folder.path() / "missing"};
  ImportReport report = import_shapes(project, paths, few_points(), {});
  CHECK(report.imported == 1);
  REQUIRE(report.refused.size() == 3);
  CHECK(report.refused[0].path == folder.path() / "in/bad.off");
  CHECK(report.refused[0].reason.find("line") == 0);
  CHECK(report.refused[1].reason == "does not exist; check the name");
  CHECK(report.refused[2].reason.find(".obj") != std::string::npos);
  CHECK(project.refused().size() == 3);

  folder.write("in/bad.off", box_off(2));
  report = import_shapes(project, {folder.path() / "in"}, few_points(), {});
  CHECK(report.imported == 1);
  CHECK(report.unchanged == 1);
  CHECK(project.refused().size() == 2);
}

TEST_CASE("of several files with one name the first by path is taken, whatever the order of the arguments") {
  const ScratchFolder folder;
  folder.write("x/a.off", box_off(1));
  folder.write("x/a.xyz", "0 0 0\n1 0 0\n0 1 0\n");
  folder.write("y/a.off", box_off(2));
  folder.write("y/p__q.off", box_off(3));
  folder.write("y/p/q.off", box_off(4));
  const std::vector<fs::path> orders[]{{folder.path() / "x", folder.path() / "y"},
                                       {folder.path() / "y", folder.path() / "x"}};
  for (const auto& paths : orders) {
    Project project = Project::in_memory();
    const ImportReport report = import_shapes(project, paths, few_points(), {});
    CHECK(names(project) == Names{"a", "p__q"});
    CHECK(project.find_shape("a")->path == folder.path() / "x/a.off");
    REQUIRE(report.refused.size() == 3);
    CHECK(report.refused[0].path == folder.path() / "x/a.xyz");
    CHECK(report.refused[0].reason.find((folder.path() / "x/a.off").string()) != std::string::npos);
  }
}

TEST_CASE("a file that the project has keeps its name and wins it") {
  const ScratchFolder folder;
  const fs::path later = folder.write("in/sub/a.off", box_off(1));
  Project project = Project::in_memory();
  import_shapes(project, {later}, few_points(), {});
  CHECK(names(project) == Names{"a"});
  folder.write("in/a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const ImportReport report = import_shapes(project, {folder.path() / "in"}, few_points(), {});
  CHECK(names(project) == Names{"a"});
  CHECK(project.find_shape("a")->path == later);
  CHECK(report.unchanged == 1);
  CHECK(report.refused.size() == 1);
}

TEST_CASE("a shape that was moved is found again; one that was changed is read again") {
  const ScratchFolder folder;
  const fs::path old_place = folder.write("old/a.off", box_off(1));
  Project project = Project::in_memory();
  import_shapes(project, {folder.path() / "old"}, few_points(), {});
  fs::rename(folder.path() / "old", folder.path() / "new");
  ImportReport report = import_shapes(project, {folder.path() / "new"}, few_points(), {});
  CHECK(report.unchanged == 1);
  CHECK(project.find_shape("a")->path == folder.path() / "new/a.off");

  folder.write("new/a.off", box_off(5));
  report = import_shapes(project, {folder.path() / "new"}, few_points(), {});
  CHECK(report.imported == 1);
  CHECK(report.unchanged == 0);

  ImportOptions more = few_points();
  more.points = 70;
  CHECK(import_shapes(project, {folder.path() / "new"}, more, {}).imported == 1);
  more.up = UpAxis::z;
  CHECK(import_shapes(project, {folder.path() / "new"}, more, {}).imported == 1);
  CHECK(project.find_shape("a")->up == UpAxis::z);
  CHECK(import_shapes(project, {folder.path() / "new"}, more, {}).unchanged == 1);
}

TEST_CASE("a cancelled import keeps what is done and goes on from there to the same result") {
  const ScratchFolder folder;
  write_chairs(folder.path(), 60);
  const std::vector<fs::path> paths{folder.path() / "shapes"};
  Project whole = Project::in_memory();
  import_shapes(whole, paths, few_points(1), {});

  Project project = Project::in_memory();
  std::stop_source source;
  JobControl control;
  control.stop = source.get_token();
  control.report = [&](std::size_t done, std::size_t, std::string_view) {
    if (done == 20) source.request_stop();
  };
  const ImportReport first = import_shapes(project, paths, few_points(), control);
  CHECK(first.cancelled);
  CHECK(first.imported >= 20);
  CHECK(first.imported < 60);
  CHECK(project.shape_count() == first.imported);

  const ImportReport second = import_shapes(project, paths, few_points(), {});
  CHECK_FALSE(second.cancelled);
  CHECK(second.unchanged == first.imported);
  CHECK(second.imported == 60 - first.imported);
  CHECK(names(project) == names(whole));
  for (const ShapeRecord& shape : whole.shapes()) {
    const ShapeId id = project.find_shape(shape.name)->id;
    CHECK(project.samples(id).points == whole.samples(shape.id).points);
  }
}

TEST_CASE("auto finds the up axes of a collection, also if it is stopped on the way") {
  const ScratchFolder folder;
  GenerateOptions generate;
  generate.count = 30;
  generate.ups = {UpAxis::y, UpAxis::z, UpAxis::minus_x};
  write_collection("chairs", generate, folder.path(), {});
  const std::vector<fs::path> paths{folder.path() / "shapes"};
  ImportOptions options = few_points();
  options.points = 300;
  options.up = std::nullopt;

  Project whole = Project::in_memory();
  import_shapes(whole, paths, options, {});
  const std::vector<ShapeRecord> shapes = whole.shapes();
  REQUIRE(shapes.size() == 30);
  std::size_t right = 0;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    CHECK(shapes[i].up_decided);
    CHECK(shapes[i].frame.rotation == upright_rotation(shapes[i].up));
    right += shapes[i].up == generate_shape("chairs", generate, i).up ? 1 : 0;
  }
  CHECK(right >= 27);
  CHECK(import_shapes(whole, paths, options, {}).unchanged == 30);

  Project stopped = Project::in_memory();
  std::stop_source source;
  JobControl control;
  control.stop = source.get_token();
  control.report = [&](std::size_t done, std::size_t, std::string_view) {
    if (done == 18) source.request_stop();
  };
  CHECK(import_shapes(stopped, paths, options, control).cancelled);
  import_shapes(stopped, paths, options, {});
  for (const ShapeRecord& shape : shapes) {
    const ShapeSamples expected = whole.samples(shape.id);
    const ShapeSamples samples = stopped.samples(stopped.find_shape(shape.name)->id);
    CHECK(samples.points == expected.points);
    CHECK(samples.features_x == expected.features_x);
  }
}
