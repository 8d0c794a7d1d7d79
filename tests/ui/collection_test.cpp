// A folder is opened, shown, fitted and saved elsewhere, by clicks where there are any.
#include <doctest/doctest.h>

#include <chrono>
#include <fstream>
#include <thread>

#include "core/session/actions.h"
#include "core/session/ground_truth.h"
#include "tests/ui/test_window.h"
#include "ui/project_actions.h"
#include "ui/thumbnail_worker.h"

using namespace archetype;
using archetype::test::TestWindow;
namespace fs = std::filesystem;

TEST_CASE("A folder opens in the grid; a click shows a shape; pictures are made") {
  TestWindow window;
  window.open_chairs(4);
  const auto& rows = window.studio().collection.rows();
  REQUIRE(window.has("cell:" + rows[2].name));
  window.click("cell:" + rows[2].name);
  window.settle();
  REQUIRE(window.studio().shape.record);
  CHECK(window.studio().shape.record->name == rows[2].name);
  CHECK(window.studio().shape.mesh);
  CHECK(window.studio().shape.samples);
  CHECK(window.studio().thumbnails.problem().empty());
  for (const ShapeRow& row : rows) CHECK(window.studio().thumbnails.use(wanted_thumbnail(row)) != 0);
}

TEST_CASE("Generated shapes are named as their labels are, which are found beside them") {
  TestWindow window;
  Studio& studio = window.studio();
  const std::string arguments[] = {"chairs", "2"};
  REQUIRE(run_command(studio, "generate", arguments));
  window.settle();
  const auto& rows = studio.collection.rows();
  REQUIRE(rows.size() == 2);
  CHECK(rows[0].name == "chair_00000");
  const GroundTruthFolders truth = ground_truth_folders(Project::open(studio.collection.path));
  REQUIRE_FALSE(truth.labels.empty());
  CHECK(fs::exists(truth.labels / "chair_00000.seg"));
}

TEST_CASE("The arrow keys and the search go through the shapes") {
  TestWindow window;
  window.open_chairs(3);
  const auto& rows = window.studio().collection.rows();
  CHECK(window.studio().ui.shape == rows[0].id);
  window.key("Right");
  window.key("Right");
  window.key("Right");
  CHECK(window.studio().ui.shape == rows[2].id);
  window.key("Left");
  CHECK(window.studio().ui.shape == rows[1].id);
  window.click("grid:filter");
  window.type("00002");
  window.frames(2);
  CHECK(shown_rows(window.studio()).size() == 1);
}

TEST_CASE("The fit of the shape in view follows edits, and what it took is measured") {
  TestWindow window;
  window.open_chairs(1);
  window.make_template();
  window.settle();
  REQUIRE(window.studio().shape.fit);
  const double before = window.studio().shape.fit->fit.energy.total();
  CHECK(window.studio().shape.fit->element_labels.size() == window.studio().shape.mesh->element_count());
  window.click("part:seat");
  window.studio().latency.clear();
  window.drag("field:Centre.y", 150, 0, 12);
  window.settle();
  CHECK(window.studio().shape.fit->fit.energy.total() != before);
  CHECK(window.studio().shape.fit->part_template ==
        window.studio().history.current().templates[window.studio().history.current().active]);
  CHECK(window.studio().latency.milliseconds().size() >= 10);
  window.key("Ctrl+Z");
  window.settle();
  CHECK(window.studio().shape.fit->fit.energy.total() == doctest::Approx(before));
}

TEST_CASE("All shapes are fitted as a job; grid and messages say so") {
  TestWindow window;
  window.open_chairs(3);
  window.make_template();
  window.click("command:fit-all");
  window.settle();
  for (const ShapeRow& row : window.studio().collection.rows()) CHECK(row.fit.has_value());
  const std::vector<JobView> jobs = window.studio().jobs.view();
  REQUIRE_FALSE(jobs.empty());
  CHECK(jobs[0].state == JobState::done);
}

TEST_CASE("Learning is a job whose result is one step that can be undone") {
  TestWindow window;
  window.open_chairs(4);
  window.make_template();
  window.click("command:fit-all");  // the project has the template then
  window.settle();
  const Document before = window.studio().history.committed();
  window.click("command:learn");
  window.settle();
  CHECK_FALSE(window.studio().history.committed() == before);
  CHECK(window.studio().jobs.view().at(0).state == JobState::done);
  for (const ShapeRow& row : window.studio().collection.rows()) CHECK(row.fit.has_value());
  window.key("Ctrl+Z");
  window.settle();
  CHECK(window.studio().history.committed() == before);
}

TEST_CASE("A suggested template is chosen by a click or the arrows, and taken by Enter or a double click") {
  TestWindow window;
  window.open_chairs(3);
  REQUIRE(run_command(window.studio(), "suggest-templates", {}));
  window.settle();
  REQUIRE_FALSE(window.studio().ui.suggestions.empty());
  CHECK(window.studio().ui.show_suggestions);
  const std::vector<Suggestion>& suggestions = window.studio().ui.suggestions;
  for (const Suggestion& each : suggestions) {
    REQUIRE(each.source);  // each shows the shape that it was made of
    CHECK(each.source->fit.parts.size() == each.found.part_template.parts.size());
  }
  const auto shape = window.studio().ui.shape;
  window.click("suggestion:1");
  CHECK(window.studio().ui.show_suggestions);
  CHECK(window.studio().history.committed().templates.empty());
  const std::size_t last = suggestions.size() - 1;
  for (std::size_t i = 0; i < last; ++i) {
    window.key("Right");  // not for the collection
    window.field_key(ImGuiKey_RightArrow);
  }
  CHECK(window.studio().ui.shape == shape);
  CHECK(window.studio().ui.chosen_suggestion == last);
  window.field_key(ImGuiKey_Enter);
  window.settle();
  CHECK_FALSE(window.studio().ui.show_suggestions);
  const auto active = [&] { return window.studio().history.committed().active_template(); };
  REQUIRE(active());
  CHECK(active()->parts == suggestions[last].found.part_template.parts);
  REQUIRE(run_command(window.studio(), "show-suggestions", {}));
  window.frames(3);
  window.double_click("suggestion:1");
  CHECK_FALSE(window.studio().ui.show_suggestions);
  CHECK(active()->parts == suggestions[0].found.part_template.parts);
  REQUIRE(run_command(window.studio(), "show-suggestions", {}));
  window.key("Escape");
  CHECK_FALSE(window.studio().ui.show_suggestions);
}

TEST_CASE("What was edited is there again when the folder is opened again") {
  TestWindow window;
  window.open_chairs(2);
  window.make_template();
  const Document made = window.studio().history.current();
  // Saved a second after the last edit.
  const auto start = std::chrono::steady_clock::now();
  while (window.studio().autosave.saved_revision != window.studio().history.committed_revision()) {
    REQUIRE(std::chrono::steady_clock::now() - start < std::chrono::seconds(20));
    window.frames();
  }
  window.settle();
  open_folder(window.studio(), window.scratch().path() / "chairs" / "shapes");
  window.settle();
  CHECK_FALSE(window.studio().history.can_undo());  // it was opened anew
  CHECK(window.studio().history.current() == made);
}

TEST_CASE("A project is saved elsewhere and opened from there") {
  TestWindow window;
  window.open_chairs(2);
  window.make_template();
  const std::string path = (window.scratch().path() / "mine.archetype").string();
  const std::string arguments[] = {path};
  CHECK(window.studio().collection.untitled);
  REQUIRE(run_command(window.studio(), "save-as", arguments));
  window.settle();
  CHECK_FALSE(window.studio().collection.untitled);
  CHECK(window.studio().collection.path == path);
  REQUIRE(run_command(window.studio(), "open-project", arguments));
  window.settle();
  CHECK(window.studio().collection.rows().size() == 2);
  CHECK(window.studio().history.current().active_template()->name == "chair");
  // Never over an existing file.
  CHECK_FALSE(run_command(window.studio(), "save-as", arguments));
}

TEST_CASE("A template is saved and loaded through the file browser") {
  TestWindow window;
  window.make_template();
  const PartTemplate made = *window.studio().history.current().active_template();
  window.click("command:save-template");
  REQUIRE(window.studio().ui.browser.open);
  window.settle();
  // The name is proposed and selected: what is typed takes its place.
  CHECK(window.studio().ui.browser.typed == "chair");
  window.type("mine");
  window.click("browser:open");
  CHECK_FALSE(window.studio().ui.browser.open);
  REQUIRE(std::filesystem::exists(window.scratch().path() / "mine.json"));
  window.click("command:delete-template");
  CHECK(window.studio().history.current().templates.empty());
  window.click("command:load-template");
  window.settle();
  window.double_click("entry:mine.json");
  REQUIRE(window.studio().history.current().active_template());
  CHECK(*window.studio().history.current().active_template() == made);
}

TEST_CASE("What cannot be opened says why, in one line, and changes nothing") {
  TestWindow window;
  for (const char* name : {"nothing-here", "notes.txt", "broken.json", "broken.archetype"}) {
    CAPTURE(name);
    const std::filesystem::path path = window.scratch().path() / name;
    if (path.has_extension()) std::ofstream(path) << "not what it says\n";
    const std::uint64_t messages = window.studio().messages.count();
    const std::string arguments[] = {path.string()};
    run_command(window.studio(), "open", arguments);
    window.settle();
    REQUIRE(window.studio().messages.count() > messages);
    const Message& last = window.studio().messages.list().back();
    CHECK(last.severity == Severity::error);
    CHECK(last.text.find(name) != std::string::npos);
    CHECK(last.text.find('\n') == std::string::npos);
    CHECK_FALSE(window.studio().collection.open());
  }
}

TEST_CASE("A broken shape is listed and the others come in") {
  TestWindow window;
  const std::filesystem::path folder = window.scratch().path() / "mixed";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "good.off")
      << "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 1 3\n3 0 2 3\n3 1 2 3\n";
  std::ofstream(folder / "bad.off") << "OFF\n9999 1 0\n0 0 0\n";
  open_folder(window.studio(), folder);
  window.settle();
  REQUIRE(window.studio().collection.rows().size() == 1);
  CHECK(window.studio().collection.rows()[0].name == "good");
  CHECK(window.studio().collection.content.refused.size() == 1);
  bool told = false;
  for (const Message& message : window.studio().messages.list())
    told |= message.text.find("bad.off") != std::string::npos;
  CHECK(told);
}

TEST_CASE("A colour that a part is given by hand is seen in the pictures of the grid") {
  TestWindow window;
  window.open_chairs(1);
  window.make_template();
  Studio& studio = window.studio();
  REQUIRE(run_command(studio, "fit-all"));
  window.settle();
  const ShapeId shape = studio.collection.rows()[0].id;
  const WantedThumbnail wanted = wanted_thumbnail(studio.collection.rows()[0]);
  REQUIRE(wanted.fitted);
  const Picture kept =
      Project::open(studio.collection.path).thumbnail(shape, std::string(parts_thumbnail)).value();
  ThumbnailWorker worker(studio.options.shaders, {});
  const auto made = [&](const WantedThumbnail& one) {
    worker.want(studio.collection.path, {one});
    while (!worker.idle() && worker.problem().empty()) {
      for (const MadeThumbnail& thumbnail : worker.take()) return thumbnail.picture;
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return Picture{};
  };
  CHECK(made(wanted) == kept);
  WantedThumbnail coloured = wanted;
  coloured.colours = std::make_shared<const HandColours>(HandColours{{"chair", {6, -1, -1}}});
  const Picture picture = made(coloured);
  CHECK(picture.width == kept.width);
  CHECK(picture != kept);
  // It is not kept in the place of the other one; and colours of other templates are none of this one.
  CHECK(Project::open(studio.collection.path).thumbnail(shape, std::string(parts_thumbnail)).value() == kept);
  coloured.colours = std::make_shared<const HandColours>(HandColours{{"table", {6, -1, -1}}});
  CHECK(made(coloured) == kept);
  const std::vector<std::uint8_t> before = window.pixels_of(studio.thumbnails.use(wanted));
  set_part_colour(studio.history, {0}, 6);
  window.settle();
  CHECK(window.pixels_of(studio.thumbnails.use(wanted)) != before);
}
