// A start without arguments has again what was open last.
#include <doctest/doctest.h>

#include "core/io/file.h"
#include "tests/ui/test_window.h"
#include "ui/project_actions.h"
#include "ui/recovery.h"

using namespace archetype;
using archetype::test::TestWindow;

namespace {

namespace fs = std::filesystem;

// As another start leaves it: nothing is open.
void start_again(TestWindow& window) {
  Studio& studio = window.studio();
  save_now(studio);
  studio.session.reset();
  studio.collection = {};
  studio.history = History({}, "Start");
  studio.autosave.saved_revision = 0;
  show_shape(studio, std::nullopt);
  begin_session(studio);
  open_last(studio);
  window.settle();
}

bool has_message(const Studio& studio, const std::string& piece) {
  for (const Message& message : studio.messages.list())
    if (message.text.find(piece) != std::string::npos) return true;
  return false;
}

}  // namespace

TEST_CASE("The folder that was open last is opened again, with what was edited") {
  TestWindow window;
  Studio& studio = window.studio();
  begin_session(studio);
  window.open_chairs(3);
  window.make_template();
  const fs::path path = studio.collection.path;
  const Document edited = studio.history.committed();
  start_again(window);
  CHECK(studio.collection.path == path);
  CHECK(studio.collection.untitled);
  CHECK(studio.collection.rows().size() == 3);
  CHECK(studio.history.committed() == edited);
}

TEST_CASE(
    "A project is opened again from where it was saved; one that is gone or broken gives way to the seats") {
  TestWindow window;
  Studio& studio = window.studio();
  begin_session(studio);
  window.open_chairs(2);
  const fs::path saved = window.scratch().path() / "kept.archetype";
  save_project_as(studio, saved);
  window.settle();
  REQUIRE(studio.collection.path == saved);
  SUBCASE("there") {
    start_again(window);
    CHECK(studio.collection.path == saved);
    CHECK(studio.collection.title == "kept");
    CHECK_FALSE(studio.collection.untitled);
    CHECK(studio.collection.rows().size() == 2);
    return;
  }
  SUBCASE("gone") {
    fs::remove(saved);
  }
  SUBCASE("broken") {
    fs::remove(saved);
    fs::remove(saved.string() + "-wal");
    fs::remove(saved.string() + "-shm");
    replace_file(saved, "this is no project");
  }
  start_again(window);
  CHECK(has_message(studio, "kept, which was open last, cannot be opened"));
  // The test window has no package of furniture: that it was looked for is all that can be seen.
  CHECK(has_message(studio, "sweethome3d"));
}

TEST_CASE("Without anything that was open before, it is the seats") {
  TestWindow window;
  open_last(window.studio());
  window.settle();
  CHECK(has_message(window.studio(), "sweethome3d"));
}
