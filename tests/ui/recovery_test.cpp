// A start after the program was killed offers what was open, and brings it back.
#include <doctest/doctest.h>

#include "core/io/file.h"
#include "core/session/actions.h"
#include "core/session/document_text.h"
#include "tests/ui/test_window.h"
#include "ui/project_actions.h"
#include "ui/recovery.h"

using namespace archetype;
using archetype::test::TestWindow;

namespace {

namespace fs = std::filesystem;

// As another process would have left it that was killed.
void leave_killed(TestWindow& window, const SessionRecord& record, const std::string& document) {
  const fs::path folder = window.studio().options.folders.data / "sessions";
  const SessionMark mark(folder);
  mark.record(record);
  if (!document.empty()) replace_file(mark.document(), document);
  // The lock of this process stays with the file that is taken away; a copy has none.
  const fs::path stem = folder / "killed";
  fs::copy(fs::path(mark.document()).replace_extension(".json"), stem.string() + ".json");
  if (!document.empty()) fs::copy(mark.document(), stem.string() + ".document");
  replace_file(stem.string() + ".lock", "");
}

}  // namespace

TEST_CASE("A project that was open when the program was killed is offered and opened") {
  TestWindow window;
  window.open_chairs(2);
  window.make_template();
  Studio& studio = window.studio();
  save_now(studio);
  const Document edited = studio.history.committed();
  const fs::path path = studio.collection.path;
  leave_killed(window, {path, studio.collection.title, studio.collection.folder}, "");

  studio.collection = {};
  studio.history = History({}, "Start");
  studio.autosave.saved_revision = 0;
  show_shape(studio, std::nullopt);
  begin_session(studio);
  window.frames(2);
  REQUIRE(offers_recovery(studio));
  window.key("Ctrl+N");  // what is behind it is out of reach
  CHECK(studio.history.committed().templates.empty());
  SUBCASE("taken") {
    window.click("recovery:open:0");
    window.settle();
    CHECK(studio.collection.path == path);
    CHECK(studio.collection.untitled);
    CHECK(studio.collection.rows().size() == 2);
    CHECK(studio.history.committed() == edited);
    CHECK_FALSE(offers_recovery(studio));
    CHECK(lost_sessions(studio.options.folders.data / "sessions").empty());
  }
  SUBCASE("the window is closed: the next start offers it again") {
    window.key("Ctrl+Q");
    window.settle();
    CHECK(studio.quit);
    CHECK(lost_sessions(studio.options.folders.data / "sessions").size() == 1);
  }
  SUBCASE("put off: it is there with its folder") {
    window.key("Escape");
    window.settle();
    CHECK_FALSE(offers_recovery(studio));
    open_folder(studio, window.scratch().path() / "chairs" / "shapes");
    window.settle();
    CHECK(studio.history.committed() == edited);
  }
  SUBCASE("opened by its path: nothing is left to offer") {
    open_folder(studio, window.scratch().path() / "chairs" / "shapes");
    window.settle();
    CHECK_FALSE(offers_recovery(studio));
    CHECK(studio.history.committed() == edited);
  }
}

TEST_CASE(
    "Templates of no project come into a file of the session, and are brought back after it was killed") {
  TestWindow window;
  Studio& studio = window.studio();
  begin_session(studio);
  window.make_template();
  const Document made = studio.history.committed();
  const std::string kept = read_file(studio.session->document(), 1 << 20);
  CHECK(parse_document(kept, "kept") == made);
  leave_killed(window, {}, kept);

  run_command(studio, "undo");
  window.settle();
  REQUIRE(studio.history.committed().templates.empty());
  studio.lost = lost_sessions(studio.options.folders.data / "sessions");
  window.frames(2);
  REQUIRE(offers_recovery(studio));
  SUBCASE("brought back, it comes into the project that is opened next") {
    window.click("recovery:open:0");
    window.settle();
    CHECK(studio.history.committed() == made);
    CHECK(lost_sessions(studio.options.folders.data / "sessions").empty());
    window.open_chairs(1);
    save_now(studio);
    CHECK(read_document(Project::open(studio.collection.path)) == made);
    CHECK(parse_document(read_file(studio.session->document(), 1 << 20), "kept").templates.empty());
  }
  SUBCASE("put off, it is offered by the next start; discarded, it is not") {
    window.click("recovery:close");
    window.settle();
    CHECK_FALSE(offers_recovery(studio));
    studio.lost = lost_sessions(studio.options.folders.data / "sessions");
    window.frames(2);
    REQUIRE(offers_recovery(studio));
    window.click("recovery:discard:0");
    window.frames(2);
    CHECK(lost_sessions(studio.options.folders.data / "sessions").empty());
  }
}
