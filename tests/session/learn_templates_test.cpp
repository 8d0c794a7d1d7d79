#include "core/session/learn_templates.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/session/import_shapes.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/small_collection.h"

using namespace archetype;
using namespace archetype::test;

namespace {

// A project of a few generated chairs, and a template that none of them looks quite like.
struct Chairs {
  ScratchFolder folder;
  Project project = Project::in_memory();

  explicit Chairs(std::size_t count, bool on_disk = false) {
    write_chairs(folder.path(), count);
    if (on_disk) project = Project::create(folder.path() / "chairs.archetype");
    import({folder.path() / "shapes"});
  }
  void import(const std::vector<std::filesystem::path>& paths, int points = 150) {
    ImportOptions options;
    options.points = points;
    import_shapes(project, paths, options, {});
  }
  LearnReport learn(int iterations = 10, bool fresh = false, const JobControl& control = {}) {
    LearnOptions options;
    options.iterations = iterations;
    options.sample_size = 8;  // judges, and others in each round
    return learn_templates(project, {start()}, {}, options, 1, fresh, 2, control);
  }
  static PartTemplate start() {
    PartTemplate result = chair_template();
    for (TemplatePart& part : result.parts) part.scale.mean *= 1.3;
    return result;
  }
  // Shape, template, yaw and energy of all.
  std::string fits() const {
    std::string text;
    for (const FitSummary& fit : project.fits())
      text += std::to_string(fit.shape) + " " + std::to_string(fit.part_template) + " " +
              std::to_string(fit.yaw_quarters) + " " + number_text(fit.energy.total()) + "\n";
    return text;
  }
  std::vector<PartTemplate> learned() const {
    std::vector<PartTemplate> templates;
    for (const TemplateRecord& record : project.templates()) templates.push_back(record.part_template);
    return templates;
  }
};

}  // namespace

TEST_CASE("learning goes into the project round by round, and templates remember where they come from") {
  Chairs chairs(20);
  const LearnReport report = chairs.learn();
  REQUIRE(report.steps.size() >= 2);
  for (const LearningStep& step : report.steps) CHECK(step.energy <= step.energy_before);
  CHECK(report.fit.fitted == 20);
  CHECK(report.learned + report.outliers <= 20);
  const std::vector<TemplateRecord> current = chairs.project.templates();
  REQUIRE_FALSE(current.empty());
  CHECK(current[0].iteration > 0);
  REQUIRE(current[0].parent);
  CHECK(chairs.project.find_template(*current[0].parent).has_value());
  for (const FitSummary& fit : chairs.project.fits()) CHECK(fit.has_labels);
}

TEST_CASE("a learning that was stopped goes on where it was, to the same templates") {
  Chairs whole(20);
  whole.learn();
  Chairs stopped(20);
  // Stopped within the second round.
  std::stop_source source;
  const JobControl control{source.get_token(), [&](std::size_t, std::size_t, std::string_view what) {
                             if (what.find("round 2") != std::string_view::npos) source.request_stop();
                           }};
  const LearnReport first = stopped.learn(10, false, control);
  CHECK(first.cancelled);
  CHECK(first.steps.size() == 1);
  CHECK(learning_start(stopped.project) == std::vector{Chairs::start()});
  const LearnReport second = stopped.learn();
  CHECK_FALSE(second.cancelled);
  CHECK(stopped.learned() == whole.learned());
  CHECK(stopped.learn().fit.kept == 20);  // nothing is left to do
  const LearnReport again = stopped.learn(10, true);
  CHECK(again.steps.size() == second.steps.size());
  CHECK(stopped.learned() == whole.learned());
}

TEST_CASE("ten rounds are gone on with where there were two, and begun anew where one is wanted") {
  Chairs whole(20);
  const LearnReport expected = whole.learn();
  REQUIRE(expected.steps.size() > 2);
  Chairs chairs(20);
  CHECK(chairs.learn(2).steps.size() == 2);
  std::set<std::string> rounds;
  std::mutex mutex;
  const JobControl control{{}, [&](std::size_t, std::size_t, std::string_view what) {
                             const std::lock_guard lock(mutex);
                             if (what.starts_with("learning, round ")) rounds.emplace(what.substr(0, 17));
                           }};
  CHECK(chairs.learn(10, false, control).steps.size() == expected.steps.size());
  CHECK_FALSE(rounds.contains("learning, round 2"));
  CHECK(rounds.contains("learning, round 3"));
  CHECK(chairs.learned() == whole.learned());
  CHECK(chairs.learn(1).steps.size() == 1);
}

TEST_CASE("where no round is left, what was learned becomes current again, with its parents and yaws") {
  Chairs chairs(20);
  CHECK_FALSE(can_go_on(chairs.project, {}, {}, 1));
  chairs.learn();
  const std::vector<TemplateRecord> learned = chairs.project.templates();
  const std::string fits = chairs.fits();
  fit_collection(chairs.project, {Chairs::start()}, {}, 2, {});
  REQUIRE(chairs.learned() == std::vector{Chairs::start()});
  chairs.learn();
  const std::vector<TemplateRecord> again = chairs.project.templates();
  REQUIRE(again.size() == learned.size());
  for (std::size_t t = 0; t < again.size(); ++t) CHECK(again[t].id == learned[t].id);
  CHECK(chairs.fits() == fits);
  CHECK(learning_start(chairs.project) == std::vector{Chairs::start()});
}

TEST_CASE("a learning can be gone on with while its options, seed, shapes and corrections are the same") {
  Chairs chairs(6);
  chairs.learn(1);
  LearnOptions options;
  options.sample_size = 8;
  CHECK(can_go_on(chairs.project, {}, options, 1));
  CHECK_FALSE(can_go_on(chairs.project, {}, {}, 1));
  CHECK_FALSE(can_go_on(chairs.project, {}, options, 2));
  LearnOptions none = options;
  none.iterations = 0;
  CHECK_FALSE(can_go_on(chairs.project, {}, none, 1));  // there is a round already
  const ShapeId first = chairs.project.shape_ids().front();
  ShapeCorrection turned;
  turned.yaw_quarters = 1;
  chairs.project.set_corrections({{first, std::make_shared<const ShapeCorrection>(turned)}});
  CHECK_FALSE(can_go_on(chairs.project, {}, options, 1));
  chairs.project.set_corrections({});
  CHECK(can_go_on(chairs.project, {}, options, 1));
}

TEST_CASE("a learning that is stopped before its first round is through changes nothing") {
  Chairs chairs(12);
  chairs.learn(1);
  const std::vector<PartTemplate> learned = chairs.learned();
  REQUIRE(learned != std::vector{Chairs::start()});
  std::stop_source source;
  const auto stop_in_round = [&](std::size_t, std::size_t, std::string_view what) {
    if (what.starts_with("learning, round 1")) source.request_stop();
  };
  const LearnReport report = chairs.learn(2, true, {source.get_token(), stop_in_round});
  CHECK(report.cancelled);
  CHECK(report.steps.empty());
  CHECK(chairs.learned() == learned);
  CHECK(chairs.project.fits().size() == 12);
  CHECK(learning_record(chairs.project)->steps.size() == 1);
}

TEST_CASE("progress tells the round, the templates, the energy and the fits") {
  Chairs chairs(12);
  std::mutex mutex;
  std::set<std::string> stages;
  std::size_t backwards = 0;
  std::size_t before = 0;
  const JobControl control{{}, [&](std::size_t done, std::size_t total, std::string_view what) {
                             const std::lock_guard lock(mutex);
                             if (!stages.emplace(what).second && done != before + 1) ++backwards;
                             before = done;
                             CHECK(done <= total);
                           }};
  const LearnReport report = chairs.learn(3, false, control);
  REQUIRE(report.steps.size() >= 2);
  CHECK(backwards == 0);  // but for what two threads report at once
  CHECK(stages.contains("learning, round 1 of at most 3, templates: 1, fits:"));
  CHECK(std::ranges::any_of(stages, [](const std::string& what) {
    return what.starts_with("learning, round 2 of at most 3, templates: ") &&
           what.find(", energy ") != std::string::npos && what.ends_with(", fits:");
  }));
  CHECK(stages.contains("fitting"));
}

TEST_CASE("the order in which shapes were imported does not matter") {
  Chairs at_once(20);
  at_once.learn();
  Chairs one_by_one(20);
  one_by_one.project = Project::in_memory();
  for (int i = 19; i >= 0; --i) {
    const std::string name = "chair_000" + std::string(i < 10 ? "0" : "") + std::to_string(i) + ".off";
    one_by_one.import({one_by_one.folder.path() / "shapes" / name});
  }
  one_by_one.learn();
  CHECK(one_by_one.learned() == at_once.learned());
}

TEST_CASE("learning starts over where the shapes are no longer the same") {
  Chairs chairs(12);
  chairs.learn(1);
  chairs.import({chairs.folder.path() / "shapes"}, 120);
  const LearnReport again = chairs.learn(1);
  CHECK(again.fit.fitted == 12);
  Chairs other(12);
  other.import({other.folder.path() / "shapes"}, 120);
  other.learn(1);
  CHECK(chairs.learned() == other.learned());
}

TEST_CASE("what another program left as the state of learning is not gone on from") {
  Chairs chairs(4);
  chairs.learn(1);
  for (const char* state : {"", "{", "[]", R"({"request":1})", R"({"request":"x","settled":"y"})"}) {
    chairs.project.set_setting(std::string(learn_state_setting), state);
    CHECK_NOTHROW(learning_start(chairs.project));
    CHECK_FALSE(learning_record(chairs.project));
    CHECK(chairs.learn(1).steps.size() == 1);
  }
}

TEST_CASE(
    "what a project tells of its learning: which templates, of which lines, and which shapes take them") {
  Chairs chairs(20);
  CHECK_FALSE(learning_record(chairs.project));
  const LearnReport report = chairs.learn();
  const std::optional<LearningRecord> record = learning_record(chairs.project);
  REQUIRE(record);
  CHECK(record->settled);
  CHECK(record->start == std::vector{Chairs::start()});
  CHECK(record->judging.size() == 8);
  REQUIRE(record->steps.size() == report.steps.size());
  for (const LearningStep& step : record->steps) {
    REQUIRE(step.lines.size() == step.templates.size());
    CHECK(step.taken.size() == record->judging.size());
    std::vector<std::size_t> members(step.templates.size());
    for (const std::size_t t : step.taken) ++members.at(t);
    CHECK(std::ranges::count(members, 0U) == 0);  // those without members are dropped
    for (const TemplateId id : step.templates)
      CHECK(std::ranges::count(record->templates, id, &TemplateRecord::id) == 1);
    for (const std::size_t line : step.lines) CHECK(record->lines.at(line).born <= step.iteration);
  }
  // Re-estimated, it is another template of the same line.
  CHECK(record->steps[0].lines[0] == 0);
  CHECK_FALSE(record->lines[0].parent);
  std::vector<TemplateId> current;
  for (const TemplateRecord& each : chairs.project.templates()) current.push_back(each.id);
  CHECK(record->steps.back().templates == current);
}

TEST_CASE("a state of learning with indices that lead nowhere is none") {
  Chairs chairs(4);
  chairs.learn(1);
  const std::string good = *chairs.project.setting(std::string(learn_state_setting));
  const nlohmann::json sound = nlohmann::json::parse(good);
  const auto is_read = [&](const nlohmann::json& state) {
    chairs.project.set_setting(std::string(learn_state_setting), state.dump());
    return learning_record(chairs.project).has_value();
  };
  CHECK(is_read(sound));
  const std::pair<const char*, nlohmann::json> changes[]{{"/steps/0/taken/0", 99},
                                                         {"/steps/0/taken/0", -1},
                                                         {"/steps/0/taken/0", 0.5e300},
                                                         {"/steps/0/taken", {0}},
                                                         {"/steps/0/lines", {7}},
                                                         {"/steps/0/lines", nlohmann::json::array()},
                                                         {"/steps/0/templates", {12345}},
                                                         {"/templates", {12345}},
                                                         {"/lines", nlohmann::json::array()},
                                                         {"/lines/0/parent", 0},
                                                         {"/lines/0/born", "x"},
                                                         {"/judging", {1}},
                                                         {"/start", nlohmann::json::array()},
                                                         {"/steps/0/energy", nullptr},
                                                         {"/initial", nlohmann::json::array()}};
  for (const auto& [where, what] : changes) {
    CAPTURE(where);
    nlohmann::json state = sound;
    state[nlohmann::json::json_pointer(where)] = what;
    CHECK_FALSE(is_read(state));
    CHECK_NOTHROW(learning_start(chairs.project));
  }
  // What was stored before there were lines: learning starts over.
  nlohmann::json old = sound;
  old.erase("lines");
  old.erase("judging");
  old["steps"][0]["templates"] = 1;
  CHECK_FALSE(is_read(old));
  CHECK(chairs.learn(1).steps.size() == 1);
  CHECK(learning_record(chairs.project));
}

TEST_CASE("a paused learning lets others write, and ends as if it had not been paused") {
  Chairs whole(20, true);
  whole.learn();
  Chairs chairs(20, true);
  const auto gate = std::make_shared<PauseGate>();
  std::atomic<bool> in_round = false;
  JobControl control;
  control.stop = {std::stop_source().get_token(), gate};
  control.report = [&](std::size_t, std::size_t, std::string_view what) {
    if (what.find("round 2") == std::string_view::npos || in_round.exchange(true)) return;
    gate->close();
  };
  std::jthread learning([&] { chairs.learn(10, false, control); });
  for (int i = 0; i < 60'000 && !in_round; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  REQUIRE(in_round);
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  {
    Project other = Project::open(chairs.project.path());
    CHECK_NOTHROW(other.set_setting("note", "written meanwhile"));
    CHECK(learning_record(other)->steps.size() == 1);  // the whole round can be seen
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    CHECK(learning_record(other)->steps.size() == 1);
  }
  gate->open();
  learning.join();
  CHECK(chairs.learned() == whole.learned());
}

TEST_CASE("learning needs a template and a shape") {
  Project empty = Project::in_memory();
  CHECK_THROWS_AS(learn_templates(empty, {chair_template()}, {}, {}, 1, false, 1, {}), PreconditionError);
  Chairs chairs(1);
  CHECK_THROWS_AS(learn_templates(chairs.project, {}, {}, {}, 1, false, 1, {}), PreconditionError);
}
