// What learning begins with, or goes on with, and what it takes the place of.
#include <doctest/doctest.h>

#include "core/session/actions.h"
#include "core/session/correction_actions.h"
#include "core/session/fit_collection.h"
#include "core/session/import_shapes.h"
#include "tests/support/small_collection.h"
#include "tests/ui/learned_window.h"
#include "ui/learning_actions.h"
#include "ui/project_actions.h"
#include "ui/widgets.h"

using namespace archetype;
using namespace archetype::test;

TEST_CASE("What learning begins with is said before and when it starts") {
  TestWindow window;
  window.open_chairs(4);
  window.make_template();
  Studio& studio = window.studio();
  const auto says = [&](const std::string& piece) {
    return what_learning_begins_with(studio).find(piece) != std::string::npos;
  };
  CHECK(says("begins with “chair” as it is in the editor"));
  window.click("command:learn");
  CHECK(studio.messages.list().back().text == "Learning: begins with “chair” as it is in the editor");
  CHECK(studio.jobs.view().front().title == "Learn from chair");
  window.settle();
  REQUIRE(studio.collection.content.learning);
  REQUIRE(studio.collection.content.learning->settled);
  // The templates are what was learned: the same again would end where they are.
  const std::string rounds = plural(studio.collection.content.learning->steps.size(), "round");
  CHECK(says("has nothing left to do from “chair” after " + rounds));
  CHECK_FALSE(learning_goes_on(studio));
  REQUIRE(run_command(studio, "rename-template", std::vector<std::string>{"seat of mine"}));
  window.settle();
  CHECK(says("begins with “seat of mine” as it is in the editor"));
  REQUIRE(run_command(studio, "duplicate-template"));
  window.settle();
  CHECK(says("the other template of the document stays as it is"));
  window.key("Ctrl+Z");
  window.key("Ctrl+Z");
  window.settle();
  auto unsettled = *studio.collection.content.learning;
  unsettled.settled = false;
  studio.collection.content.learning = std::make_shared<const LearningRecord>(unsettled);
  const std::string goes_on =
      "goes on after round " + std::to_string(unsettled.steps.size()) + " from “chair”";
  CHECK(says(goes_on));
  CHECK(learning_goes_on(studio));

  SUBCASE("also where other templates were fitted since") {
    studio.collection.content.templates = {chair_template()};
    CHECK(says(goes_on));
  }
  SUBCASE("and where there is another template beside, but not from that one") {
    PartTemplate other = chair_template();
    other.name = "other";
    add_template(studio.history, other, "Add other");
    CHECK(says("begins with “other” as it is in the editor; the other template"));
    CHECK_FALSE(learning_goes_on(studio));
    select_template(studio.history, 0);
    CHECK(says(goes_on));
  }
  SUBCASE("not where a shape was corrected since") {
    const ShapeRow& row = studio.collection.rows().front();
    pin_yaw(studio.history, {row.id, row.name}, 1);
    CHECK(says("begins anew with “chair”, as what was learned is of other shapes, corrections or options"));
    CHECK(says("takes the place of the template that was learned"));
    CHECK_FALSE(learning_goes_on(studio));
  }
  SUBCASE("not beyond the last round") {
    while (unsettled.steps.size() < 10) unsettled.steps.push_back(unsettled.steps.back());
    studio.collection.content.learning = std::make_shared<const LearningRecord>(unsettled);
    CHECK(says("has nothing left to do from “chair” after 10 rounds"));
    CHECK_FALSE(learning_goes_on(studio));
  }
}

TEST_CASE("A learning that goes on and is stopped at once leaves what it had, whatever was fitted since") {
  TestWindow window;
  write_chairs(window.scratch().path() / "chairs", 12);
  const std::filesystem::path path = window.scratch().path() / "one-round.archetype";
  PartTemplate start = chair_template();
  for (TemplatePart& part : start.parts) part.scale.mean *= 1.3;
  {
    Project project = Project::create(path);
    ImportOptions few_points;
    few_points.points = 150;
    import_shapes(project, {window.scratch().path() / "chairs" / "shapes"}, few_points, {});
    LearnOptions once;
    once.iterations = 1;
    learn_templates(project, {start}, {}, once, learning_seed, false, 1, {});
    REQUIRE_FALSE(is_over(learning_record(project).value(), {}));
  }
  open_project(window.studio(), path);
  window.settle();
  Studio& studio = window.studio();
  const std::shared_ptr<const PartTemplate> learned = studio.history.committed().templates.at(0);
  add_template(studio.history, chair_template(), "Add another");
  REQUIRE(run_command(studio, "fit-all"));
  window.settle();
  REQUIRE(studio.collection.content.templates.size() == 1);
  REQUIRE(studio.collection.content.templates[0] != *learned);
  select_template(studio.history, 0);
  REQUIRE(learning_goes_on(studio));
  REQUIRE(run_command(studio, "learn"));
  select_template(studio.history, 1);  // while it runs
  REQUIRE(run_command(studio, "cancel-jobs"));
  window.settle();
  const Document& after = studio.history.committed();
  REQUIRE(after.templates.size() == 2);
  CHECK(*after.templates[0] == *learned);
  CHECK(after.templates[1]->name != learned->name);
  CHECK(studio.messages.list().back().text == "Learning stopped after 1 round; learn again to go on");
  select_template(studio.history, 0);
  CHECK(learning_goes_on(studio));
}

TEST_CASE("What was learned comes back by learning again after undo, without a round") {
  LearnedWindow window;
  Studio& studio = window.studio();
  const Document learned = window.history().committed();
  const std::size_t rounds = window.record().steps.size();
  window.key("Ctrl+Z");
  window.settle();
  REQUIRE(window.history().committed() != learned);
  CHECK(what_learning_begins_with(studio).starts_with("brings back what"));
  // Another fit in between makes other templates the project's.
  REQUIRE(run_command(studio, "fit-all"));
  window.settle();
  CHECK(what_learning_begins_with(studio).starts_with("brings back what"));
  REQUIRE(run_command(studio, "learn"));
  window.settle();
  CHECK(window.history().committed() == learned);
  CHECK(window.record().steps.size() == rounds);
  CHECK(studio.collection.content.learning_can_go_on);
}

TEST_CASE("Learning begins with both templates of a project, says so, and one undo brings both back") {
  TestWindow window;
  write_chairs(window.scratch().path() / "chairs", 4);
  const std::filesystem::path path = window.scratch().path() / "two.archetype";
  {
    Project project = Project::create(path);
    import_shapes(project, {window.scratch().path() / "chairs" / "shapes"}, {}, {});
    PartTemplate wide = chair_template();
    wide.name = "wide";
    wide.parts[0].scale.mean.x() *= 1.05;  // so alike that they can only become one
    fit_collection(project, {chair_template(), wide}, {}, 1, {});
  }
  open_project(window.studio(), path);
  window.settle();
  Studio& studio = window.studio();
  const Document before = studio.history.current();
  REQUIRE(before.templates.size() == 2);
  const std::string begins = "begins with “chair”, “wide” as they are in the editor";
  CHECK(what_learning_begins_with(studio) == begins);
  REQUIRE(run_command(studio, "learn"));
  window.settle();
  CHECK(studio.collection.content.learning->start.size() == 2);
  CHECK(studio.history.current().templates.size() == 1);
  window.key("Ctrl+Z");
  window.settle();
  CHECK(studio.history.current() == before);
  CHECK(what_learning_begins_with(studio).starts_with("brings back what “chair”, “wide” became"));
  window.key("Ctrl+Shift+Z");
  window.settle();
  CHECK(studio.history.current().templates.size() == 1);
}
