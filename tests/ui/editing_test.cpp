// Edits by mouse and keyboard: each is one step, undone and redone to equal documents.
#include <doctest/doctest.h>

#include "core/session/actions.h"
#include "tests/ui/test_window.h"

using namespace archetype;
using archetype::test::TestWindow;

namespace {

const PartTemplate& shown(TestWindow& window) {
  return *window.studio().history.current().active_template();
}

// What the edit left is undone by Ctrl+Z, comes back by Ctrl+Shift+Z, and was one step.
void check_one_step(TestWindow& window, const Document& before, std::size_t steps_before) {
  const History& history = window.studio().history;
  const Document after = history.current();
  CHECK_FALSE(after == before);
  CHECK_FALSE(history.has_preview());
  CHECK(history.entries().size() == steps_before + 1);
  window.key("Ctrl+Z");
  CHECK(history.current() == before);
  window.key("Ctrl+Shift+Z");
  CHECK(history.current() == after);
}

// At this share of the target's width: a field may have buttons beside the text.
void click_at(TestWindow& window, const std::string& name, float share) {
  for (const Target& target : window.studio().targets) {
    if (target.name != name) continue;
    ImGui::GetIO().MousePos = {target.low_x + share * (target.high_x - target.low_x),
                               (target.low_y + target.high_y) / 2};
  }
  window.frames(2);
  ImGui::GetIO().MouseDown[0] = true;
  window.frames();
  window.let_go();
}

struct Edit {
  const char* name;
  void (*make)(TestWindow&);
};

const Edit edits[] = {
    {"add", [](TestWindow& w) { w.click("command:add-part"); }},
    {"copy", [](TestWindow& w) { w.click("command:duplicate-part"); }},
    {"mirror",
     [](TestWindow& w) {
       w.click("part:leg");
       w.click("command:mirror-part");
     }},
    {"delete by key", [](TestWindow& w) { w.key("Delete"); }},
    {"must exist", [](TestWindow& w) { w.click("field:Must exist"); }},
    {"drag a coordinate", [](TestWindow& w) { w.drag("field:Centre.y", 60, 0); }},
    {"drag a size", [](TestWindow& w) { w.drag("field:Half size.x", -40, 0); }},
    {"drag an angle", [](TestWindow& w) { w.drag("field:Rotation.z", 30, 0); }},
    {"drag a spread", [](TestWindow& w) { w.drag("field:± centre.x", 30, 0); }},
    {"drag the existence", [](TestWindow& w) { w.drag("field:Existence", -50, 0); }},
    {"type a coordinate",
     [](TestWindow& w) {
       w.double_click("field:Centre.x");
       w.type("0.25");
       w.field_key(ImGuiKey_Enter);
     }},
    {"type a label",
     [](TestWindow& w) {
       click_at(w, "field:Label", 0.1f);
       w.type("12");
       w.field_key(ImGuiKey_Enter);
     }},
    {"raise a label", [](TestWindow& w) { click_at(w, "field:Label", 0.95f); }},
    {"type a name",
     [](TestWindow& w) {
       w.click("field:Name");
       w.type("cushion");
       w.field_key(ImGuiKey_Enter);
     }},
};

}  // namespace

TEST_CASE("Every edit by mouse or keyboard is one step that can be undone and redone") {
  for (const Edit& edit : edits) {
    CAPTURE(edit.name);
    TestWindow window;
    window.make_template();
    window.click("part:seat");
    CHECK(window.studio().ui.part == 0);
    const Document before = window.studio().history.current();
    const std::size_t steps = window.studio().history.entries().size();
    edit.make(window);
    check_one_step(window, before, steps);
  }
}

TEST_CASE("Numbers go where they were typed") {
  TestWindow window;
  window.make_template();
  window.click("part:back");
  window.double_click("field:Centre.x");
  window.type("0.25");
  window.field_key(ImGuiKey_Enter);
  CHECK(shown(window).parts[1].position.mean == Vec3(0.25, 0.7, -0.5));
}

TEST_CASE("A drag shows every step live and Esc puts it back") {
  TestWindow window;
  window.make_template();
  window.click("part:seat");
  const Document before = window.studio().history.current();
  window.press_on("field:Centre.y");
  window.move_by(20, 0);
  const double first = shown(window).parts[0].position.mean.y();
  window.move_by(20, 0);
  CHECK(shown(window).parts[0].position.mean.y() > first);
  CHECK(window.studio().history.has_preview());
  window.key("Escape");
  CHECK(window.studio().history.current() == before);
  window.move_by(30, 0);  // the button is still down: nothing follows it any more
  CHECK(window.studio().history.current() == before);
  window.let_go();
  CHECK(window.studio().history.current() == before);
  CHECK_FALSE(window.studio().history.has_preview());
}

TEST_CASE("A drag goes on with the part that it began with") {
  TestWindow window;
  window.make_template();
  window.click("part:seat");
  const Document before = window.studio().history.current();
  window.press_on("field:Centre.y");
  window.move_by(20, 0);
  window.key("Tab");  // refused
  CHECK(window.studio().ui.part == 0);
  window.studio().ui.part = 1;  // however it came about
  window.frames(2);
  window.move_by(20, 0);
  window.let_go();
  const PartTemplate& first = *before.templates[0];
  CHECK(shown(window).parts[1] == first.parts[1]);
}

TEST_CASE("A number that is none, or too large for a file, changes nothing or becomes the largest") {
  TestWindow window;
  window.make_template();
  window.click("part:seat");
  const Document before = window.studio().history.current();
  window.double_click("field:Centre.x");
  window.type("1e999");
  window.field_key(ImGuiKey_Enter);
  CHECK(window.studio().history.current() == before);
}

TEST_CASE("A scripted drag ends where its part is deleted") {
  TestWindow window;
  window.make_template();
  window.click("part:leg");
  const std::string arguments[] = {"0", "1", "0", "1000"};
  REQUIRE(run_command(window.studio(), "drag-part", arguments));
  window.frames(3);
  CHECK(window.studio().history.has_preview());
  window.key("Delete");
  window.frames(3);
  CHECK_FALSE(window.studio().drag);
  CHECK_FALSE(window.studio().history.has_preview());
  CHECK(shown(window).parts.size() == 2);
}

TEST_CASE("Keys for commands stay out of text fields, keys of text fields stay in them") {
  TestWindow window;
  window.make_template();
  window.click("part:seat");
  window.click("field:Name");
  window.key("Delete");
  CHECK(shown(window).parts.size() == 3);
  window.key("Ctrl+Z");
  CHECK(window.studio().history.current().active_template() != nullptr);
  window.key("F1");
  CHECK(window.studio().ui.help);
}

TEST_CASE("The history list goes to any step") {
  TestWindow window;
  window.make_template();
  const Document before = window.studio().history.current();
  window.click("command:add-part");
  window.click("command:add-part");
  window.click("tab:History");
  window.frames(2);
  window.click("history:1");
  CHECK(window.studio().history.current() == before);
  CHECK(window.studio().history.entries().size() == 4);
}

TEST_CASE("The history list shows the step that was done or undone last, however long it is") {
  TestWindow window;
  window.make_template();
  for (int i = 0; i < 60; ++i) window.click("command:add-part");
  window.click("tab:History");
  window.frames(3);
  const std::size_t last = window.studio().history.position();
  CHECK(window.has("history:" + std::to_string(last)));
  CHECK_FALSE(window.has("history:1"));
  window.key("Ctrl+Z");
  window.key("Ctrl+Z");
  window.frames(3);
  CHECK(window.has("history:" + std::to_string(last - 2)));
  while (window.studio().history.position() > 1) window.key("Ctrl+Z");
  window.frames(3);
  CHECK(window.has("history:1"));
  CHECK_FALSE(window.has("history:" + std::to_string(last)));
}

TEST_CASE("The palette finds a command by its words and runs it") {
  TestWindow window;
  window.make_template();
  window.key("Ctrl+P");
  CHECK(window.studio().ui.palette.open);
  window.type("light th");
  window.frames(2);
  window.field_key(ImGuiKey_Enter);
  CHECK_FALSE(window.studio().ui.palette.open);
  CHECK(window.studio().settings.theme == "light");
  window.key("Ctrl+P");
  window.key("Escape");
  CHECK_FALSE(window.studio().ui.palette.open);
}

TEST_CASE("Bars between the panels can be dragged") {
  TestWindow window;
  const double before = window.studio().settings.left_width;
  window.drag("splitter:left", 40, 0);
  CHECK(window.studio().settings.left_width == doctest::Approx(before + 40));
}
