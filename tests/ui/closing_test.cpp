// The window closes at once where nothing is lost and nothing is missed, and asks where it would be.
#include <doctest/doctest.h>

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

void close(TestWindow& window) {
  window.key("Ctrl+Q");
  window.settle();
}

bool asks(TestWindow& window) {
  return window.has("close:cancel");
}

// An untitled project whose templates were edited.
void edit_untitled(TestWindow& window) {
  window.open_chairs(1);
  window.make_template();
  window.click("part:seat");
  window.key("Ctrl+D");
}

}  // namespace

TEST_CASE("A window in which nothing was edited closes without a question") {
  TestWindow window;
  SUBCASE("without a project") {}
  SUBCASE("with one") {
    window.open_chairs(1);
  }
  close(window);
  CHECK(window.studio().quit);
}

TEST_CASE("An edit that was undone needs no question, nor does a window without a person") {
  TestWindow window;
  edit_untitled(window);
  SUBCASE("undone") {
    while (run_command(window.studio(), "undo")) continue;
  }
  SUBCASE("a script") {
    window.studio().attended = false;
  }
  close(window);
  CHECK(window.studio().quit);
}

TEST_CASE("An untitled project with edits is kept, or goes on") {
  TestWindow window;
  edit_untitled(window);
  Studio& studio = window.studio();
  const Document edited = studio.history.committed();
  close(window);
  CHECK_FALSE(studio.quit);
  REQUIRE(asks(window));
  // What is behind the question is out of reach.
  window.key("Ctrl+Z");
  window.key("Delete");
  CHECK(studio.history.committed() == edited);
  SUBCASE("Escape goes on") {
    window.key("Escape");
    CHECK_FALSE(asks(window));
    CHECK_FALSE(studio.quit);
    window.key("Ctrl+Z");
    CHECK_FALSE(studio.history.committed() == edited);
  }
  SUBCASE("so does Cancel") {
    window.click("close:cancel");
    window.frames(2);
    CHECK_FALSE(asks(window));
    CHECK_FALSE(studio.quit);
  }
  SUBCASE("Enter keeps it") {
    window.field_key(ImGuiKey_Enter);
    window.settle();
    CHECK(studio.quit);
    CHECK(stored(studio.collection.path) == edited);
  }
  SUBCASE("the button keeps it") {
    window.click("close:keep");
    window.settle();
    CHECK(studio.quit);
    CHECK(stored(studio.collection.path) == edited);
  }
  SUBCASE("discarded, it is as it was when it was opened") {
    window.click("close:discard");
    window.settle();
    CHECK(studio.quit);
    CHECK(stored(studio.collection.path).templates.empty());
  }
}

TEST_CASE("An untitled project is saved as one of its own at the end, and the window closes then") {
  TestWindow window;
  edit_untitled(window);
  Studio& studio = window.studio();
  const Document edited = studio.history.committed();
  close(window);
  REQUIRE(asks(window));
  window.click("command:save-as");
  REQUIRE(studio.ui.browser.open);
  CHECK_FALSE(asks(window));
  SUBCASE("the browser closed without a name: it goes on") {
    window.click("browser:cancel");
    window.frames(3);
    CHECK_FALSE(asks(window));
    CHECK_FALSE(studio.quit);
  }
  SUBCASE("saved") {
    const fs::path path = window.scratch().path() / "mine.archetype";
    window.frames();  // the field gets the keyboard
    window.type(path.string());
    window.click("browser:open");
    window.settle();
    CHECK(studio.quit);
    CHECK(stored(path) == edited);
  }
  if (studio.quit) return;
  // A project with a file of its own closes without a question: every edit is in it.
  save_project_as(studio, window.scratch().path() / "mine.archetype");
  window.settle();
  add_part(studio.history, {});
  close(window);
  CHECK(studio.quit);
  CHECK(stored(studio.collection.path) == studio.history.committed());
}

TEST_CASE("Templates of no project are not lost without a question, and can become a project") {
  TestWindow window;
  window.make_template();
  Studio& studio = window.studio();
  const Document made = studio.history.committed();
  close(window);
  REQUIRE(asks(window));
  CHECK_FALSE(studio.quit);
  SUBCASE("discarded") {
    window.click("close:discard");
    window.frames(2);
    CHECK(studio.quit);
  }
  SUBCASE("saved as a project") {
    window.click("command:save-as");
    REQUIRE(studio.ui.browser.open);
    const fs::path path = window.scratch().path() / "made.archetype";
    window.frames();
    window.type(path.string());
    window.click("browser:open");
    window.settle();
    CHECK(studio.quit);
    CHECK(stored(path) == made);
  }
}

TEST_CASE("With a full disk the window asks before it closes, and closes by itself once there is space") {
  TestWindow window;
  window.open_chairs(1);
  Studio& studio = window.studio();
  save_project_as(studio, window.scratch().path() / "mine.archetype");
  window.settle();
  {
    const test::DiskLimit full(1000);
    window.make_template();
    close(window);
    CHECK_FALSE(studio.quit);
    REQUIRE(asks(window));
    CAPTURE(studio.autosave.problem);
    CHECK(studio.autosave.problem.find("disk is full") != std::string::npos);
    window.click("close:retry");
    window.settle();
    CHECK_FALSE(studio.quit);
    REQUIRE(asks(window));
    SUBCASE("closed without what could not be saved") {
      window.click("close:discard");
      window.frames(2);
      CHECK(studio.quit);
      save_now(studio);
      const test::DiskLimit none(RLIM_INFINITY);
      CHECK(stored(studio.collection.path).templates.empty());
      return;
    }
    SUBCASE("space is freed") {}
  }
  studio.autosave.not_before = {};  // five seconds are over
  window.frames();
  window.settle();
  CHECK(studio.quit);
  CHECK(stored(studio.collection.path) == studio.history.committed());
}
