// Every panel is drawn on an empty, a small and a large document, in a large and a small window, and
// everything in it is really clicked.
#include <doctest/doctest.h>

#include <set>

#include "core/session/actions.h"
#include "tests/ui/made_learning.h"
#include "tests/ui/test_window.h"
#include "ui/panels.h"

using namespace archetype;
using archetype::test::TestWindow;

namespace {

void make_large_document(TestWindow& window) {
  PartTemplate part_template;
  part_template.name = "large";
  for (int i = 0; i < 200; ++i) {
    TemplatePart part;
    part.name = "part with quite a long name, number " + std::to_string(i);
    part.label = i;
    part.must_exist = i % 2 == 0;
    part_template.parts.push_back(part);
  }
  for (int i = 0; i < 50; ++i)
    add_template(window.studio().history, part_template, "Step " + std::to_string(i));
  CollectionRows& rows = window.studio().collection.content;
  window.studio().collection.path = window.scratch().path() / "large.archetype";
  window.studio().collection.title = "Large";
  for (ShapeId id = 1; id <= 10'000; ++id) {
    FitSummary fit;
    fit.shape = id;
    fit.energy.features = 1.0 / static_cast<double>(id);
    rows.rows.push_back({id, "shape_" + std::to_string(id), 1000, {}, fit});
  }
  rows.learning = std::make_shared<const LearningRecord>(test::made_learning(30, 12, 100));
  ++window.studio().collection.revision;
  for (int i = 0; i < 2000; ++i) window.studio().messages.warn("message " + std::to_string(i));
  window.studio().ui.part = 100;
}

// Commands that leave the window, or start minutes of work, are left out of the clicking.
bool leaves_the_window(const std::string& target) {
  for (const char* name : {"quit", "generate", "open-seats"})
    if (target.find(name) != std::string::npos) return true;
  return false;
}

// Clicks everything that can be seen, the way somebody would who wants to know what it all does.
void click_everything(TestWindow& window) {
  std::set<std::string> clicked;
  for (int round = 0; round < 120; ++round) {
    std::string next;
    for (const Target& target : window.studio().targets) {
      const bool seen =
          target.low_x >= 0 && target.low_y >= 0 && target.high_x <= 1280 && target.high_y <= 720;
      if (seen && !leaves_the_window(target.name) && !clicked.contains(target.name)) {
        next = target.name;
        break;
      }
    }
    if (next.empty()) break;
    CAPTURE(next);
    clicked.insert(next);
    window.click(next);
    window.key("Escape");
    window.key("Escape");
    CHECK_FALSE(window.studio().history.has_preview());
  }
  CHECK(clicked.size() > 20);
}

}  // namespace

TEST_CASE("Every panel is drawn alone on empty, small and large documents") {
  for (const Panel& panel : all_panels()) {
    CAPTURE(std::string(panel.name));
    for (const int size : {0, 1, 2}) {
      TestWindow window(400, 300);
      if (size == 1) window.make_template();
      if (size == 2) make_large_document(window);
      for (int frame = 0; frame < 2; ++frame) {
        window.studio().targets.clear();
        ImGui::NewFrame();
        ImGui::SetNextWindowSize({380, 280});
        ImGui::Begin("alone");
        panel.draw(window.studio());
        ImGui::End();
        ImGui::Render();
      }
      CHECK(ImGui::GetDrawData()->TotalVtxCount > 0);
    }
  }
}

TEST_CASE("Everything in the window can be clicked: empty") {
  TestWindow window;
  click_everything(window);
}

TEST_CASE("Everything in the window can be clicked: chairs and a template") {
  TestWindow window;
  window.open_chairs(3);
  window.make_template();
  window.studio().ui.part = 0;
  click_everything(window);
}

TEST_CASE("Everything in the window can be clicked: ten thousand shapes and two hundred parts") {
  TestWindow window;
  make_large_document(window);
  window.frames(2);
  std::size_t cells = 0;
  for (const Target& target : window.studio().targets) cells += target.name.starts_with("cell:");
  CHECK(cells > 3);
  CHECK(cells < 100);  // only those in sight
  click_everything(window);
}

TEST_CASE("Everything in the window can be clicked: a long learning of many templates") {
  TestWindow window;
  make_large_document(window);
  REQUIRE(run_command(window.studio(), "show-learning", {}));
  window.frames(4);
  CHECK(window.has("learned:30:1"));  // the newest round is in sight
  click_everything(window);
}

TEST_CASE("The window can be small, and its text twice as large") {
  for (const float scale : {1.0f, 2.0f}) {
    TestWindow window(640, 400, scale);
    window.make_template();
    window.studio().ui.part = 1;
    window.key("Ctrl+P");
    window.key("F1");
    window.frames(3);
    const Picture picture = window.window().picture();
    CHECK(picture.width == 640);
    // Nothing wider than the window: its right edge shows the inspector and not a scroll bar of the whole.
    CHECK(window.has("part:seat"));
  }
}

TEST_CASE("What is drawn repeats to the bit") {
  Picture first;
  for (int run = 0; run < 2; ++run) {
    TestWindow window(800, 500);
    window.make_template();
    window.frames(5);
    if (run == 0)
      first = window.window().picture();
    else
      CHECK(window.window().picture() == first);
  }
}
