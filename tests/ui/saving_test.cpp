// What is edited comes into the file of its own project, whatever is opened, closed or saved elsewhere
// meanwhile.
#include <doctest/doctest.h>

#include <fstream>
#include <thread>

#include "core/session/actions.h"
#include "tests/support/disk_limit.h"
#include "tests/ui/test_window.h"
#include "ui/project_actions.h"

using namespace archetype;
using archetype::test::TestWindow;

namespace {

namespace fs = std::filesystem;

Document stored(const fs::path& project) {
  return read_document(Project::open(project));
}

void write_shape(const fs::path& folder, const std::string& name) {
  fs::create_directories(folder);
  std::ofstream(folder / (name + ".off"))
      << "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 1 3\n3 0 2 3\n3 1 2 3\n";
}

}  // namespace

TEST_CASE("What was edited a moment before the end is saved") {
  TestWindow window;
  window.open_chairs(1);
  window.make_template();
  add_part(window.studio().history, {});
  CHECK(unsaved(window.studio()));
  save_now(window.studio());
  CHECK_FALSE(unsaved(window.studio()));
  CHECK(stored(window.studio().collection.path) == window.studio().history.current());
}

TEST_CASE("What was edited a moment before another project is opened is saved in its own") {
  TestWindow window;
  window.open_chairs(1);
  const fs::path first = window.studio().collection.path;
  window.make_template();
  window.click("part:seat");
  window.key("Ctrl+D");
  const Document edited = window.studio().history.current();
  write_shape(window.scratch().path() / "other", "only");
  open_folder(window.studio(), window.scratch().path() / "other");
  window.settle();
  REQUIRE(window.studio().collection.path != first);
  save_now(window.studio());
  CHECK(stored(first) == edited);
  // The templates of one project are not those of the next.
  CHECK(window.studio().history.current().templates.empty());
  CHECK(stored(window.studio().collection.path).templates.empty());
}

TEST_CASE("Templates that were made before anything was open are saved with what is opened first") {
  TestWindow window;
  window.make_template();
  const Document made = window.studio().history.current();
  window.open_chairs(1);
  CHECK(window.studio().history.current() == made);
  save_now(window.studio());
  CHECK(stored(window.studio().collection.path) == made);
}

TEST_CASE("A save that fails says so once, and is tried again") {
  TestWindow window;
  window.open_chairs(1);
  Studio& studio = window.studio();
  const fs::path project = studio.collection.path;
  const fs::path away = project.string() + ".away";
  fs::rename(project, away);
  window.make_template();
  save_soon(studio);
  const auto tried_once = [&] {
    const std::uint64_t messages = studio.messages.count();
    studio.autosave.not_before = {};
    window.frames();
    window.settle();
    return studio.messages.count() - messages;
  };
  CHECK(tried_once() + tried_once() + tried_once() <= 1);
  CHECK(studio.messages.list().back().severity == Severity::error);
  CHECK(wants_frames(studio));
  fs::rename(away, project);
  tried_once();
  CHECK(stored(project) == studio.history.current());
  CHECK_FALSE(wants_frames(studio));
}

TEST_CASE("What was edited is in the file before a drag that comes after it has ended") {
  TestWindow window;
  window.open_chairs(1);
  window.make_template();
  Studio& studio = window.studio();
  const Document made = studio.history.committed();
  Document dragged = made;
  PartTemplate moved = *made.templates[0];
  moved.parts[0].position.mean.x() += 1;
  dragged.templates[0] = std::make_shared<const PartTemplate>(moved);
  studio.history.preview(dragged);
  window.settle();
  CHECK(stored(studio.collection.path) == made);
}

TEST_CASE("A full disk loses nothing that was saved, says so for as long as it lasts, and is tried again") {
  TestWindow window;
  window.open_chairs(1);
  window.make_template();
  Studio& studio = window.studio();
  const Document made = studio.history.committed();
  {
    const test::DiskLimit full(1000);
    add_part(studio.history, {});
    window.settle();
    CHECK(studio.messages.list().back().severity == Severity::error);
    CHECK(studio.messages.list().back().text.find("disk is full") != std::string::npos);
    CHECK(studio.autosave.problem.find("disk is full") != std::string::npos);
    CHECK(wants_frames(studio));
    add_part(studio.history, {});  // work goes on
    window.settle();
  }
  CHECK(stored(studio.collection.path) == made);
  CHECK(wants_frames(studio));  // tried again without anybody doing anything
  studio.autosave.not_before = {};
  window.frames();
  window.settle();
  CHECK(studio.autosave.problem.empty());
  CHECK(stored(studio.collection.path) == studio.history.committed());
  CHECK_FALSE(wants_frames(studio));
}

TEST_CASE("Edits that are made while the project is saved elsewhere come into the copy") {
  TestWindow window;
  window.open_chairs(1);
  window.make_template();
  const fs::path path = window.scratch().path() / "copy.archetype";
  save_project_as(window.studio(), path);
  add_part(window.studio().history, {});
  const Document edited = window.studio().history.current();
  window.settle();
  REQUIRE(window.studio().collection.path == path);
  save_now(window.studio());
  CHECK(stored(path) == edited);
}

TEST_CASE("A project that comes into view while another one is copied stays in view") {
  TestWindow window;
  window.open_chairs(1);
  window.make_template();
  const Document made = window.studio().history.current();
  write_shape(window.scratch().path() / "other", "only");
  open_folder(window.studio(), window.scratch().path() / "other");
  window.studio().jobs.wait_for_work();  // without a frame, so that nothing is applied yet
  const fs::path copy = window.scratch().path() / "copy.archetype";
  save_project_as(window.studio(), copy);
  window.settle();
  CHECK(window.studio().collection.title == "other");
  CHECK(window.studio().collection.rows().size() == 1);
  CHECK(window.studio().collection.rows()[0].name == "only");
  CHECK(stored(copy) == made);
  CHECK(stored(window.studio().collection.path).templates.empty());
}

TEST_CASE("Rows that were read of one project never show in the next") {
  TestWindow window;
  window.open_chairs(3);
  Studio& studio = window.studio();
  const fs::path chairs = studio.collection.path;
  write_shape(window.scratch().path() / "other", "only");
  open_folder(studio, window.scratch().path() / "other");
  window.studio().jobs.wait_for_work();  // without a frame, so that nothing is applied yet
  studio.rows_reader.request(chairs, false);
  studio.rows_reader.wait(std::chrono::minutes(1));
  window.frames();
  REQUIRE(studio.collection.title == "other");
  CHECK(studio.collection.rows().size() <= 1);
}

TEST_CASE("While a project is fitted it is neither fitted once more nor copied") {
  TestWindow window;
  window.open_chairs(2);
  window.make_template();
  Studio& studio = window.studio();
  const auto reason = [&](const char* name) { return why_not(studio, *find_command(studio, name)); };
  CHECK(reason("fit-all").empty());
  CHECK(reason("save-as").empty());
  REQUIRE(run_command(studio, "fit-all"));
  CHECK_FALSE(reason("fit-all").empty());
  CHECK_FALSE(reason("save-as").empty());
  window.settle();
  CHECK(reason("fit-all").empty());
  CHECK(reason("save-as").empty());
}

TEST_CASE("Saving the project over a file that is there is refused without offering it") {
  TestWindow window;
  window.open_chairs(1);
  const fs::path there = window.scratch().write("there.archetype", "mine");
  window.key("Ctrl+Shift+S");
  REQUIRE(window.studio().ui.browser.open);
  window.type(there.string());  // the field has the keyboard
  window.click("browser:open");
  CHECK(window.studio().ui.browser.open);
  CHECK_FALSE(window.studio().ui.browser.asked_to_replace);
  CHECK(window.studio().ui.status.find("exists already") != std::string::npos);
}

TEST_CASE("Templates of one name, as other programs write them, can be told apart and chosen") {
  TestWindow window;
  window.open_chairs(1);
  const fs::path project = window.studio().collection.path;
  {
    Project written = Project::open(project);
    TemplateRecord record;
    record.part_template.name = "chair";
    const TemplateId first = written.add_template(record);
    record.part_template.parts.resize(1);
    record.part_template.parts[0].name = "seat";
    written.set_current_templates({first, written.add_template(record)});
  }
  open_project(window.studio(), project);
  window.settle();
  const History& history = window.studio().history;
  REQUIRE(history.current().templates.size() == 2);
  CHECK(history.current().templates[0]->name == "chair");
  CHECK(history.current().templates[1]->name == "chair 2");
  window.click("template:choose");
  window.click("template:1");
  CHECK(history.current().active == 1);
}

TEST_CASE("A file that was changed is shown anew once it is imported again") {
  TestWindow window;
  const fs::path folder = window.scratch().path() / "shapes";
  write_shape(folder, "one");
  open_folder(window.studio(), folder);
  window.settle();
  Studio& studio = window.studio();
  REQUIRE(studio.shape.mesh);
  const WantedThumbnail before = wanted_thumbnail(studio.collection.rows()[0]);
  const std::vector<std::uint8_t> picture = window.pixels_of(studio.thumbnails.use(before));
  std::ofstream(folder / "one.off") << "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  add_shapes(studio, {folder});
  window.settle();
  REQUIRE(studio.shape.record);
  CHECK(studio.shape.record->element_count == 1);
  REQUIRE(studio.shape.mesh);
  CHECK(studio.shape.mesh->face_count() == 1);
  CHECK(wanted_thumbnail(studio.collection.rows()[0]) != before);
  CHECK(window.pixels_of(studio.thumbnails.use(wanted_thumbnail(studio.collection.rows()[0]))) != picture);
}

TEST_CASE("A picture that was drawn of an older fit is not kept") {
  TestWindow window;
  window.open_chairs(1);
  window.make_template();
  const ShapeId shape = window.studio().collection.rows()[0].id;
  Project project = Project::open(window.studio().collection.path);
  const ThumbnailSource unfitted = thumbnail_source(project, shape);
  run_command(window.studio(), "fit-all");
  window.settle();
  const std::string kind = "another kind";
  const Picture picture{1, 1, {1, 2, 3, 4}};
  CHECK_FALSE(keep_thumbnail(project, shape, kind, picture, unfitted));
  CHECK_FALSE(project.thumbnail(shape, kind));
  CHECK(keep_thumbnail(project, shape, kind, picture, thumbnail_source(project, shape)));
  CHECK(project.thumbnail(shape, kind));
}

TEST_CASE("Templates that another program learned come beside those that were edited") {
  TestWindow window;
  window.open_chairs(1);
  window.make_template();
  save_now(window.studio());
  const Document edited = window.studio().history.current();
  const fs::path path = window.studio().collection.path;
  CHECK(stored(path) == edited);
  {
    Project project = Project::open(path);
    TemplateRecord record;
    record.part_template = *edited.active_template();
    record.part_template.parts[0].scale.mean *= 1.1;
    project.set_current_templates({project.add_template(record)});
  }
  const Document both = stored(path);
  REQUIRE(both.templates.size() == edited.templates.size() + 1);
  CHECK(both.active_template()->name == edited.active_template()->name);
  CHECK(both.active_template()->parts != edited.active_template()->parts);
  CHECK(both.templates[1]->name != edited.active_template()->name);
  CHECK(both.templates[1]->parts == edited.active_template()->parts);
  // What is stored after that is as it was edited.
  add_part(window.studio().history, {});
  save_now(window.studio());
  CHECK(stored(path) == window.studio().history.current());
}
