// The learning panel, looking into what was learned, and pausing.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/session/actions.h"
#include "core/session/correction_actions.h"
#include "core/session/fit_collection.h"
#include "core/session/import_shapes.h"
#include "tests/support/small_collection.h"
#include "tests/ui/made_learning.h"
#include "tests/ui/test_window.h"
#include "ui/learning_actions.h"
#include "ui/learning_flow.h"
#include "ui/project_actions.h"
#include "ui/widgets.h"

using namespace archetype;
using namespace archetype::test;

namespace {

// Chairs from which was learned, with the panel in sight.
struct LearnedWindow : TestWindow {
  explicit LearnedWindow(std::size_t chairs = 4) {
    open_chairs(chairs);
    make_template();
    click("command:learn");
    settle();
    REQUIRE(studio().collection.content.learning);
    REQUIRE_FALSE(studio().collection.content.learning->steps.empty());
  }
  const LearningRecord& record() { return *studio().collection.content.learning; }
  const History& history() { return studio().history; }
};

}  // namespace

TEST_CASE("The flow of shapes: members add up, bands connect them, moves are those to another line") {
  const LearningRecord record = made_learning(6, 3, 20);
  const std::vector<FlowColumn> columns = learning_flow(record);
  REQUIRE(columns.size() == 7);
  CHECK(columns[0].nodes.size() == 1);
  CHECK(columns[0].nodes[0].members.size() == 20);
  CHECK(columns[1].nodes[1].spawned);
  CHECK_FALSE(columns[2].nodes[1].spawned);
  CHECK_FALSE(columns[2].nodes[1].changed);
  CHECK(columns[2].nodes[0].changed);
  for (std::size_t c = 1; c < columns.size(); ++c) {
    std::size_t members = 0;
    std::size_t moved = 0;
    std::size_t in_bands = 0;
    for (const FlowNode& node : columns[c].nodes) members += node.members.size();
    for (std::size_t i = 0; i < record.judging.size(); ++i) {
      const auto line = [&](std::size_t k) { return record.steps[k].lines[record.steps[k].taken[i]]; };
      moved += line(c - 1) != (c == 1 ? 0 : line(c - 2));
    }
    for (const FlowBand& band : columns[c].bands) {
      in_bands += band.shapes.size();
      CHECK(band.moved == (columns[c - 1].nodes[band.from].line != columns[c].nodes[band.to].line));
    }
    CHECK(members == 20);
    CHECK(in_bands == 20);
    CHECK(columns[c].moved == moved);
  }
  CHECK(columns[1].moved > 0);
  CHECK(learning_flow(made_learning(0, 1, 0)).size() == 1);
}

TEST_CASE("A line that ends is told of: what it became one with, or that no shape took it") {
  LearningRecord record = made_learning(3, 3, 20);
  // As before, but that in round 3 the third is merged into the first.
  LearningStep& last = record.steps[2];
  last.templates.pop_back();
  last.lines.pop_back();
  for (std::size_t& taken : last.taken) taken = taken == 2 ? 0 : taken;
  std::vector<FlowColumn> columns = learning_flow(record);
  CHECK(columns[1].ended.empty());
  CHECK(columns[2].ended.empty());
  REQUIRE(columns[3].ended.size() == 1);
  CHECK(columns[3].ended[0].into == 0);
  CHECK(end_text(columns[2], columns[3], columns[3].ended[0]) == "“chair 3” and “chair” became one, “chair”");
  const TemplateId changed = std::exchange(last.templates[0], record.steps[1].templates[0]);
  columns = learning_flow(record);
  CHECK(end_text(columns[2], columns[3], columns[3].ended[0]) ==
        "“chair 3” is gone: its shapes take “chair”");
  last.templates[0] = changed;
  last.taken = {0, 1};
  last.taken.resize(20);
  std::swap(last.taken[2], last.taken[1]);
  record.steps[1].taken = std::vector<std::size_t>(20, 2);
  columns = learning_flow(record);
  REQUIRE(columns[3].ended.size() == 1);
  CHECK(end_text(columns[2], columns[3], columns[3].ended[0]) ==
        "“chair 3” is gone: its shapes take several others");
  record.steps[1].taken = std::vector<std::size_t>(20, 0);
  columns = learning_flow(record);
  CHECK(end_text(columns[2], columns[3], columns[3].ended[0]) == "“chair 3” is gone: no shape took it");
}

TEST_CASE("Learning opens its panel, which shows every round") {
  LearnedWindow window;
  CHECK(window.studio().ui.bottom_tab == BottomTab::learning);
  CHECK(window.has("energy-plot"));
  const std::size_t rounds = window.record().steps.size();
  for (std::size_t round = 0; round <= rounds; ++round) {
    CHECK(window.has("round:" + std::to_string(round)));
    CHECK(window.has("learned:" + std::to_string(round) + ":1"));
  }
  window.click("energy-plot");
  CHECK(window.studio().ui.learning.round.has_value());
}

TEST_CASE("A template of any round is looked at without touching the document, and Esc leads back") {
  LearnedWindow window;
  const Document before = window.history().current();
  const std::uint64_t revision = window.history().revision();
  const std::size_t steps = window.history().entries().size();
  const double of_document = window.studio().shape.fit->fit.energy.total();
  for (std::size_t round = 0; round <= window.record().steps.size(); ++round) {
    window.click("learned:" + std::to_string(round) + ":1");
    window.settle();
    REQUIRE(window.studio().ui.look);
    const std::shared_ptr<const PartTemplate> look = window.studio().ui.look->part_template;
    CHECK(*look == *learning_flow(window.record())[round].nodes[0].part_template);
    CHECK(shown_template(window.studio()) == look);
    REQUIRE(window.studio().shape.fit);
    CHECK(window.studio().shape.fit->part_template == look);  // the shape in view is fitted with it
    CHECK(window.history().current() == before);
    CHECK(window.history().revision() == revision);
    CHECK(window.history().entries().size() == steps);
    CHECK(window.has("command:take-look"));
  }
  // Nothing can be dragged or selected meanwhile.
  window.click("viewport");
  CHECK_FALSE(window.studio().ui.part);
  window.drag("viewport", 40, 10);
  CHECK(window.history().revision() == revision);
  window.key("Escape");
  window.settle();
  CHECK_FALSE(window.studio().ui.look);
  CHECK_FALSE(window.has("command:take-look"));
  CHECK(window.history().revision() == revision);
  CHECK(window.studio().shape.fit->fit.energy.total() == doctest::Approx(of_document));
}

TEST_CASE("The picture in the viewport is that of the template that is looked at") {
  LearnedWindow window;
  window.settle();
  const Picture before = window.window().picture();
  window.click("learned:0:1");
  window.settle();
  window.click("command:stop-looking");
  ImGui::GetIO().MousePos = {1, 1};
  window.settle();
  const auto drawn = [&] { return window.studio().viewport.pane().drawn; };
  CHECK_FALSE(drawn()->looked_at);
  window.click("learned:0:1");
  window.settle();
  CHECK(drawn()->looked_at == window.studio().ui.look->part_template);
}

TEST_CASE("What is looked at is taken as one step that can be undone") {
  LearnedWindow window;
  const Document before = window.history().current();
  const std::size_t steps = window.history().entries().size();
  window.click("learned:0:1");
  const PartTemplate looked_at = *window.studio().ui.look->part_template;
  window.click("command:take-look");
  window.settle();
  CHECK_FALSE(window.studio().ui.look);
  CHECK(window.history().entries().size() == steps + 1);
  REQUIRE(window.history().current().active_template());
  CHECK(window.history().current().active_template()->parts == looked_at.parts);
  CHECK(window.history().current().templates.size() == before.templates.size() + 1);
  window.key("Ctrl+Z");
  CHECK(window.history().current() == before);
}

TEST_CASE("An edit of the document ends the look at another template") {
  LearnedWindow window;
  window.click("learned:0:1");
  REQUIRE(window.studio().ui.look);
  window.key("Ctrl+Z");  // the templates before learning
  CHECK_FALSE(window.studio().ui.look);
}

TEST_CASE("Members and shapes that moved bring themselves into view") {
  LearnedWindow window;
  window.click("learned:0:1");
  const std::vector<ShapeRow>& rows = window.studio().collection.rows();
  for (const ShapeRow& row : {rows[2], rows[1]}) {
    window.click("member:" + row.name);
    CHECK(window.studio().ui.shape == row.id);
  }
  // A made-up learning of the same shapes, in which one moves.
  window.studio().collection.content.learning =
      std::make_shared<const LearningRecord>(made_learning(2, 2, rows.size()));
  window.frames(3);
  window.click("round:1");
  const std::vector<FlowColumn> columns = learning_flow(window.record());
  REQUIRE(columns[1].moved > 0);
  std::size_t listed = 0;
  for (const Target& target : window.studio().targets) listed += target.name.starts_with("member:");
  CHECK(listed == columns[1].moved);
}

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

TEST_CASE("A round that is chosen elsewhere comes into sight in the chart of many rounds") {
  TestWindow window;
  window.open_chairs(2);
  window.make_template();
  Studio& studio = window.studio();
  studio.collection.content.learning = std::make_shared<const LearningRecord>(made_learning(30, 3, 2));
  show_learning(studio);
  window.frames(4);
  const auto inside = [&](const std::string& name) {
    const Target& plot = *std::ranges::find(studio.targets, "energy-plot", &Target::name);
    const auto found = std::ranges::find(studio.targets, name, &Target::name);
    return found != studio.targets.end() && found->low_x > plot.high_x && found->high_x < plot.high_x + 700;
  };
  CHECK(inside("round:30"));
  CHECK_FALSE(inside("round:2"));
  studio.ui.learning = {2, std::nullopt};
  window.frames(4);
  CHECK(inside("round:2"));
  CHECK_FALSE(inside("round:30"));
  studio.ui.learning = {30, std::nullopt};
  window.frames(4);
  CHECK(inside("round:30"));
}

TEST_CASE("A learning that is stopped before its first round says that nothing was changed, and nothing is") {
  TestWindow window;
  window.open_chairs(6);
  window.make_template();
  Studio& studio = window.studio();
  const Document before = studio.history.current();
  window.click("command:learn");
  REQUIRE(run_command(studio, "cancel-jobs"));
  window.settle();
  CHECK(studio.messages.list().back().text ==
        "Learning stopped before the end of a round; nothing was changed");
  CHECK(studio.ui.status == studio.messages.list().back().text);
  CHECK(studio.history.current() == before);
  CHECK_FALSE(studio.collection.content.learning);
  for (const ShapeRow& row : studio.collection.rows()) CHECK_FALSE(row.fit.has_value());
  CHECK(window.has("command:learn"));
}

TEST_CASE("What was learned is there again after a restart") {
  const ScratchFolder kept;
  const std::filesystem::path path = kept.path() / "chairs.archetype";
  LearningRecord before;
  {
    LearnedWindow window;
    before = window.record();
    save_now(window.studio());
    Project::open(window.studio().collection.path).copy_to(path);
  }
  TestWindow again;
  open_project(again.studio(), path);
  again.settle();
  REQUIRE(again.studio().collection.content.learning);
  const LearningRecord& after = *again.studio().collection.content.learning;
  REQUIRE(after.steps.size() == before.steps.size());
  CHECK(after.steps.back().energy == before.steps.back().energy);
  CHECK(after.steps.back().taken == before.steps.back().taken);
  again.key("L");
  again.frames(5);  // until the chart has scrolled to its newest round
  again.click("learned:" + std::to_string(after.steps.size()) + ":1");
  CHECK(again.studio().ui.look.has_value());
}

TEST_CASE("Templates are learned from the shapes alone, beside those that are there") {
  TestWindow window;
  window.open_chairs(2);
  const auto templates = [&] { return window.studio().history.committed().templates; };
  REQUIRE(templates().empty());
  REQUIRE(run_command(window.studio(), "learn-automatically"));
  window.settle();
  const auto learned = templates();
  REQUIRE_FALSE(learned.empty());
  CHECK(window.studio().collection.content.learning);
  window.key("Ctrl+Z");
  CHECK(templates().empty());
  window.make_template();
  const auto made = templates();
  REQUIRE(run_command(window.studio(), "learn-automatically"));
  window.settle();
  REQUIRE(templates().size() == made.size() + learned.size());
  CHECK(*templates()[0] == *made[0]);
  CHECK(templates()[1]->parts == learned[0]->parts);
}

TEST_CASE("A learning is paused and goes on, from its own panel and from that of the jobs") {
  TestWindow window;
  window.open_chairs(6);
  window.make_template();
  window.click("command:learn");
  window.frames(2);
  const std::string title = window.studio().jobs.view().at(0).title;
  window.click("pause:" + title);
  REQUIRE(window.studio().jobs.view().at(0).state == JobState::paused);
  CHECK(window.studio().jobs.resting());
  window.settle();  // a paused job is nothing to wait for
  CHECK(window.studio().jobs.view().at(0).state == JobState::paused);
  // The shape in view is fitted as ever.
  window.studio().ui.part = 0;
  window.key("Ctrl+D");
  window.settle();
  CHECK(window.studio().shape.fit->fit.parts.size() == 4);
  window.key("Ctrl+Z");
  window.click("tab:Jobs");
  window.frames(2);
  window.click("pause:" + title);
  CHECK(window.studio().jobs.view().at(0).state != JobState::paused);
  window.settle();
  CHECK(window.studio().jobs.view().at(0).state == JobState::done);
  REQUIRE(window.studio().collection.content.learning);
  CHECK_FALSE(window.studio().collection.content.learning->steps.empty());
}

TEST_CASE("The commands pause-jobs and resume-jobs say why not, and do so") {
  TestWindow window;
  window.open_chairs(6);
  window.make_template();
  CHECK_FALSE(run_command(window.studio(), "pause-jobs"));
  window.click("command:fit-all");
  REQUIRE(run_command(window.studio(), "pause-jobs"));
  CHECK_FALSE(run_command(window.studio(), "pause-jobs"));
  CHECK(window.studio().jobs.resting());
  REQUIRE(run_command(window.studio(), "resume-jobs"));
  CHECK_FALSE(run_command(window.studio(), "resume-jobs"));
  window.settle();
  for (const ShapeRow& row : window.studio().collection.rows()) CHECK(row.fit.has_value());
}
