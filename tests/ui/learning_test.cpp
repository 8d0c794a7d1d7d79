// The learning panel, looking into what was learned, and pausing.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "tests/ui/learned_window.h"
#include "tests/ui/made_learning.h"
#include "tests/ui/test_window.h"
#include "ui/learning_actions.h"
#include "ui/learning_flow.h"
#include "ui/project_actions.h"

using namespace archetype;
using namespace archetype::test;

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
