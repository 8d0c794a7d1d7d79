// Several parts selected: by mouse and keys, and what is done to them together.
#include "ui/selection.h"

#include <doctest/doctest.h>

#include "core/model/part_colours.h"
#include "core/session/actions.h"
#include "core/session/mirror_pairs.h"
#include "tests/ui/test_window.h"
#include "ui/template_compare.h"

using namespace archetype;
using archetype::test::TestWindow;

namespace {

const PartTemplate& shown(TestWindow& window) {
  return *window.studio().history.current().active_template();
}

void click_with(TestWindow& window, bool ImGuiIO::*key, const std::string& target) {
  ImGui::GetIO().*key = true;
  window.click(target);
  ImGui::GetIO().*key = false;
  window.frames();
}

bool same(const Box& a, const Box& b) {
  return (a.centre - b.centre).norm() < 1e-9 && (a.half_extent - b.half_extent).norm() < 1e-9 &&
         std::abs(a.orientation.dot(b.orientation)) > 1 - 1e-12;
}

}  // namespace

TEST_CASE("Ctrl takes parts of the list in and out, Shift takes all between, Ctrl+A all") {
  TestWindow window;
  window.make_template();
  UiState& ui = window.studio().ui;
  window.click("part:seat");
  click_with(window, &ImGuiIO::KeyCtrl, "part:leg");
  CHECK(selected_parts(ui) == PartList{2, 0});
  click_with(window, &ImGuiIO::KeyCtrl, "part:leg");
  CHECK(selected_parts(ui) == PartList{0});
  click_with(window, &ImGuiIO::KeyShift, "part:leg");
  CHECK(selected_parts(ui) == PartList{0, 1, 2});
  window.click("part:back");
  CHECK(selected_parts(ui) == PartList{1});
  window.key("Ctrl+A");
  CHECK(selected_parts(ui).size() == 3);
  window.key("Escape");
  CHECK(selected_parts(ui).empty());
  CHECK_FALSE(is_selected(ui, 0));
}

TEST_CASE("What is deleted, split or undone leaves no part selected that is not there") {
  TestWindow window;
  window.make_template();
  window.key("Ctrl+A");
  window.key("Ctrl+D");
  CHECK(selected_parts(window.studio().ui) == PartList{3, 4, 5});
  window.key("Ctrl+Z");
  CHECK(selected_parts(window.studio().ui).empty());
  window.key("Ctrl+A");
  window.key("Delete");
  CHECK(shown(window).parts.empty());
  CHECK(selected_parts(window.studio().ui).empty());
}

TEST_CASE(
    "Undo, redo and the history leave the same parts selected, not those that come to stand in their place") {
  TestWindow window;
  window.make_template();
  const UiState& ui = window.studio().ui;
  window.click("part:back");
  window.key("K");
  CHECK(selected_parts(ui) == PartList{1, 2});
  window.key("Ctrl+Z");
  CHECK(selected_parts(ui) == PartList{1});
  window.click("part:leg");
  window.key("Ctrl+Shift+Z");
  REQUIRE(shown(window).parts[3].name == "leg");
  CHECK(selected_parts(ui) == PartList{3});
  rename_part(window.studio().history, 3, "foot");
  window.key("Ctrl+Z");
  CHECK(selected_parts(ui) == PartList{3});
  window.click("tab:History");
  window.frames();
  window.click("history:1");
  REQUIRE(shown(window).parts.size() == 3);
  CHECK(selected_parts(ui) == PartList{2});
  window.key("Ctrl+N");
  window.key("Shift+A");
  window.key("Ctrl+Z");
  CHECK(selected_parts(ui).empty());
}

TEST_CASE("The numbers that all have are set for all that are selected, in one step") {
  TestWindow window;
  window.make_template();
  window.key("Ctrl+A");
  const std::size_t steps = window.studio().history.entries().size();
  window.click("field:Must exist");
  CHECK(window.studio().history.entries().size() == steps + 1);
  for (const TemplatePart& part : shown(window).parts) CHECK(part.must_exist);
}

TEST_CASE("Boxes are copied from one template into another, with their links and names of their own") {
  TestWindow window;
  window.make_template();
  window.click("part:leg");
  window.click("command:mirror-part");
  CHECK(shown(window).parts.size() == 4);
  CHECK(window.has("command:unlink-parts"));
  click_with(window, &ImGuiIO::KeyCtrl, "part:leg");
  window.key("Ctrl+C");
  window.key("Ctrl+N");
  window.key("Ctrl+V");
  window.key("Ctrl+V");
  REQUIRE(shown(window).parts.size() == 4);
  CHECK(mirror_partner(shown(window), 0) == 1);
  CHECK(mirror_partner(shown(window), 2) == 3);
  CHECK(shown(window).parts[2].name == "leg 3");
  CHECK(selected_parts(window.studio().ui) == PartList{2, 3});
}

TEST_CASE("Boxes that are held together move, grow and turn as one body") {
  const std::vector<PlacedPart> placed{{3, {{1, 0, 0}, {0.5, 0.2, 0.1}}}, {1, {{-1, 1, 0}, {0.1, 0.2, 0.5}}}};
  const Box held = *held_box(placed);
  CHECK(same(held, {{0.2, 0.5, 0}, {1.3, 0.7, 0.5}}));
  Box to = held;
  to.centre += Vec3(1, 2, 3);
  auto result = carried(placed, held, to);
  CHECK(result[0].part == 3);
  CHECK(same(result[0].box, {{2, 2, 3}, {0.5, 0.2, 0.1}}));
  to = held;
  to.half_extent.x() *= 2;
  result = carried(placed, held, to);
  CHECK(same(result[0].box, {{1.8, 0, 0}, {1, 0.2, 0.1}}));
  CHECK(same(result[1].box, {{-2.2, 1, 0}, {0.2, 0.2, 0.5}}));
  to = held;
  to.orientation = Eigen::Quaterniond(Eigen::AngleAxisd(0.5, Vec3::UnitY()));
  result = carried(placed, held, to);
  CHECK(same(carried(result, to, held)[1].box, placed[1].box));
  const Vec3 corner = placed[0].box.to_world({1, 1, 1});
  CHECK((result[0].box.to_world({1, 1, 1}) - (held.centre + to.orientation * (corner - held.centre))).norm() <
        1e-9);
}

TEST_CASE("A part is given a colour by hand, which goes with it; its swatch is clicked") {
  TestWindow window;
  window.make_template();
  window.click("part:back");
  CHECK(part_colour(shown(window), 1) == part_colour(1));
  window.click("colour:choose");
  window.frames(2);
  window.click("colour:4");
  CHECK(part_colour(shown(window), 1) == part_colour(4));
  window.click("part:seat");
  window.key("Delete");
  CHECK(part_colour(shown(window), 0) == part_colour(4));
  window.key("Ctrl+Z");
  window.key("Ctrl+Z");
  CHECK(part_colour(shown(window), 1) == part_colour(1));
}

TEST_CASE("Templates are renamed, duplicated, reordered and compared from their menu") {
  TestWindow window;
  window.make_template();
  const History& history = window.studio().history;
  window.click("template:more");
  window.frames(2);
  window.click("menu:duplicate-template");
  REQUIRE(history.current().templates.size() == 2);
  CHECK(history.current().active == 1);
  remove_parts(window.studio().history, {2});
  set_part_box(window.studio().history, 0, {{0, 0, 0.1}, {0.6, 0.16, 0.6}, Eigen::Quaterniond::Identity()});
  REQUIRE(run_command(window.studio(), "compare-template"));
  window.frames(2);
  CHECK(window.has("command:stop-comparing"));
  const auto other = compared_template(window.studio());
  REQUIRE(other);
  const std::vector<PartDifference> differences = compare_templates(shown(window), *other);
  REQUIRE(differences.size() == 3);
  CHECK(differences[0].moved == doctest::Approx(0.1));
  CHECK(differences[0].larger == doctest::Approx(2));
  CHECK(differences[1].moved == 0);
  CHECK_FALSE(differences[2].here);
  CHECK(differences[2].name == "leg");
  REQUIRE(run_command(window.studio(), "template-up"));
  CHECK(history.current().active == 0);
  CHECK(compared_template(window.studio()) == other);
  window.click("command:stop-comparing");
  CHECK_FALSE(compared_template(window.studio()));
  window.click("template:more");
  window.frames(2);
  window.type("stool");  // the field has the keyboard, its text selected
  window.field_key(ImGuiKey_Enter);
  CHECK(shown(window).name == "stool");
  CHECK_FALSE(window.has("field:Template name"));
}

TEST_CASE("F2 leads to the field of the part's name, and what is typed is its name") {
  TestWindow window;
  window.open_chairs(1);
  window.make_template();
  window.click("part:back");
  window.key("F2");
  window.frames();
  window.type("backrest");
  window.field_key(ImGuiKey_Enter);
  const PartTemplate& chair = *window.studio().history.committed().active_template();
  CHECK(chair.parts[1].name == "backrest");
  CHECK(chair.parts[0].name == "seat");
}

TEST_CASE("A name that was typed is kept by whatever leaves its field, and dropped by Escape") {
  TestWindow window;
  window.open_chairs(1);
  window.make_template();
  History& history = window.studio().history;
  const Document before = history.committed();
  window.click("part:back");
  const auto type_name = [&](const char* name) {
    window.key("F2");
    window.frames();
    window.type(name);
  };
  type_name("rest");
  SUBCASE("Tab leads to the label") {
    window.field_key(ImGuiKey_Tab);
    window.type("7");
    window.field_key(ImGuiKey_Enter);
    CHECK(history.committed().active_template()->parts[1].name == "rest");
    CHECK(history.committed().active_template()->parts[1].label == 7);
    CHECK(history.undo());
    CHECK(history.undo());
    CHECK(history.committed() == before);
  }
  SUBCASE("a click on another part") {
    window.click("part:seat");
    CHECK(history.committed().active_template()->parts[1].name == "rest");
    CHECK(history.committed().active_template()->parts[0].name == "seat");
  }
  SUBCASE("Escape") {
    window.field_key(ImGuiKey_Escape);
    CHECK(history.committed() == before);
    CHECK_FALSE(history.has_preview());
  }
}
