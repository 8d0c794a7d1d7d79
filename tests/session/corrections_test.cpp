// Corrections by hand: each done, undone and redone, and heeded by the next fit and by learning.
#include <doctest/doctest.h>

#include <algorithm>
#include <functional>

#include "core/base/error.h"
#include "core/session/correction_actions.h"
#include "core/session/fit_collection.h"
#include "core/session/import_shapes.h"
#include "core/session/learn_templates.h"
#include "core/session/learning_corrections.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/small_collection.h"

using namespace archetype;
using namespace archetype::test;

namespace {

const NamedShape stool{7, "stool"};
const NamedShape bench{9, "bench"};
const ContentHash sampling{{1, 2}};
const std::vector<std::uint32_t> some{3, 5, 4};

History start() {
  Document document;
  document.templates.push_back(std::make_shared<const PartTemplate>(chair_template()));
  return History(document, "Start");
}

ShapeCorrection of(const History& history, const NamedShape& shape) {
  const ShapeCorrection* correction = correction_of(history.current(), shape.id);
  return correction ? *correction : ShapeCorrection{};
}

// A project of a few generated chairs.
struct Chairs {
  ScratchFolder folder;
  Project project = Project::in_memory();

  explicit Chairs(std::size_t count) {
    write_chairs(folder.path(), count);
    ImportOptions options;
    options.points = 150;
    import_shapes(project, {folder.path() / "shapes"}, options, {});
  }
  PartTemplate bench() const {
    PartTemplate wide = chair_template();
    wide.name = "bench";
    for (TemplatePart& part : wide.parts) part.position.mean.x() *= 1.5;
    return wide;
  }
  FitCollectionReport fit(unsigned threads = 2) {
    return fit_collection(project, {chair_template(), bench()}, {}, threads, {});
  }
  void correct(ShapeId shape, const ShapeCorrection& correction) {
    Corrections all = project.corrections();
    all[shape] = std::make_shared<const ShapeCorrection>(correction);
    project.set_corrections(all);
  }
  std::string template_of(ShapeId shape) const {
    return project.find_template(project.fit(shape)->part_template)->part_template.name;
  }
  LearnReport learn(unsigned threads = 2) {
    LearnOptions options;
    options.iterations = 3;
    options.sample_size = 8;
    PartTemplate start = chair_template();
    for (TemplatePart& part : start.parts) part.scale.mean *= 1.3;
    return learn_templates(project, {start}, {}, options, 1, false, threads, {});
  }
};

}  // namespace

TEST_CASE("each correction is done, undone and redone to the same documents") {
  struct Action {
    const char* name;
    std::function<void(History&)> run;
  };
  const std::vector<NamedShape> both{stool, bench};
  const std::vector<Action> actions{
      {"yaw", [](History& h) { pin_yaw(h, stool, 2); }},
      {"template", [](History& h) { pin_template(h, stool, "chair"); }},
      {"yaw and template", [](History& h) { pin_yaw_and_template(h, bench, 1, "chair"); }},
      {"outlier", [&](History& h) { mark_shapes(h, both, ShapeMark::outlier); }},
      {"learn", [&](History& h) { mark_shapes(h, both, ShapeMark::learn); }},
      {"paint", [](History& h) { pin_samples(h, stool, sampling, some, "seat"); }},
      {"paint nothing", [](History& h) { pin_samples(h, bench, sampling, some, ""); }},
      {"free some", [](History& h) { unpin_samples(h, stool, sampling, std::vector<std::uint32_t>{4}); }},
      {"free all", [](History& h) { unpin_all_samples(h, stool); }},
      {"free yaw", [](History& h) { pin_yaw(h, stool, std::nullopt); }},
      {"free template", [](History& h) { pin_template(h, stool, ""); }},
      {"unmark", [&](History& h) { mark_shapes(h, both, ShapeMark::none); }},
      {"clear", [&](History& h) { clear_corrections(h, both); }},
  };
  History history = start();
  std::vector<Document> states{history.current()};
  for (const Action& action : actions) {
    CAPTURE(action.name);
    action.run(history);
    CHECK_FALSE(history.current() == states.back());
    states.push_back(history.current());
    CHECK(history.entries().size() == states.size());
    action.run(history);  // once more changes nothing, and makes no step
    CHECK(history.entries().size() == states.size());
  }
  CHECK(history.current() == states.front());
  for (std::size_t i = states.size() - 1; i-- > 0;) {
    REQUIRE(history.undo());
    CHECK(history.current() == states[i]);
  }
  for (std::size_t i = 1; i < states.size(); ++i) {
    REQUIRE(history.redo());
    CHECK(history.current() == states[i]);
  }
}

TEST_CASE("what is painted over belongs to one part; another sampling begins anew") {
  History history = start();
  pin_samples(history, stool, sampling, some, "seat");
  CHECK(of(history, stool).pinned == PinnedParts{{"seat", {3, 4, 5}}});
  pin_samples(history, stool, sampling, std::vector<std::uint32_t>{5, 6, 5}, "leg");
  CHECK(of(history, stool).pinned == PinnedParts{{"seat", {3, 4}}, {"leg", {5, 6}}});
  const ContentHash other{{1, 3}};
  pin_samples(history, stool, other, std::vector<std::uint32_t>{1}, "leg");
  CHECK(of(history, stool).pinned == PinnedParts{{"leg", {1}}});
  CHECK(of(history, stool).sampling == other);
  unpin_samples(history, stool, other, std::vector<std::uint32_t>{1});
  CHECK_FALSE(history.current().corrections);
  CHECK_THROWS_AS(pin_yaw(history, stool, 4), PreconditionError);
  CHECK_THROWS_AS(mark_shapes(history, {}, ShapeMark::outlier), PreconditionError);
}

TEST_CASE("a stroke is previews and one step") {
  History history = start();
  pin_samples(history, stool, sampling, std::vector<std::uint32_t>{1}, "seat", Stage::live);
  pin_samples(history, stool, sampling, std::vector<std::uint32_t>{1, 2}, "seat", Stage::live);
  CHECK(history.has_preview());
  CHECK(of(history, stool).pinned.at("seat").size() == 2);
  pin_samples(history, stool, sampling, std::vector<std::uint32_t>{1, 2}, "seat");
  CHECK(history.entries().size() == 2);
  CHECK(history.undo());
  CHECK_FALSE(history.current().corrections);
}

TEST_CASE("pins follow the names of templates and parts") {
  History history = start();
  pin_template(history, stool, "chair");
  pin_samples(history, stool, sampling, some, "seat");
  const Document before = history.current();
  rename_active_template(history, "armchair");
  CHECK(of(history, stool).part_template == "armchair");
  rename_part(history, 0, "cushion");
  CHECK(of(history, stool).pinned == PinnedParts{{"cushion", {3, 4, 5}}});
  history.undo();
  history.undo();
  CHECK(history.current() == before);
}

TEST_CASE("the next fit heeds a pinned yaw, and fits no other shape anew") {
  Chairs chairs(5);
  chairs.fit();
  const ShapeId shape = chairs.project.shape_ids()[1];
  const ShapeFit free = chairs.project.fit(shape)->fit;
  ShapeCorrection correction;
  correction.yaw_quarters = (free.yaw_quarters + 1) % 4;
  chairs.correct(shape, correction);
  FitCollectionReport report = chairs.fit();
  CHECK(report.fitted == 1);
  CHECK(report.kept == 4);
  CHECK(chairs.project.fit(shape)->fit.yaw_quarters == correction.yaw_quarters);
  CHECK(chairs.fit().fitted == 0);  // it holds from now on

  chairs.project.set_corrections({});
  CHECK(chairs.fit().fitted == 1);
  CHECK(chairs.project.fit(shape)->fit.yaw_quarters == free.yaw_quarters);
  CHECK(chairs.project.fit(shape)->fit.labels == free.labels);
}

TEST_CASE("the next fit heeds a pinned template") {
  Chairs chairs(4);
  chairs.fit();
  const ShapeId shape = chairs.project.shape_ids()[2];
  ShapeCorrection correction;
  correction.part_template = chairs.template_of(shape) == "bench" ? "chair" : "bench";
  chairs.correct(shape, correction);
  CHECK(chairs.fit().fitted == 1);
  CHECK(chairs.template_of(shape) == correction.part_template);
  correction.part_template = "sofa";  // there is none: any will do
  chairs.correct(shape, correction);
  CHECK(chairs.fit().fitted == 1);
}

TEST_CASE("the next fit heeds painted points, and not those of another sampling") {
  Chairs chairs(3);
  chairs.fit();
  const ShapeId shape = chairs.project.shape_ids()[0];
  const auto record = chairs.project.find_shape(shape);
  ShapeCorrection correction;
  correction.pinned["back"] = {0, 1, 2, 3, 50, 149};
  correction.sampling = sampling_of(*record);
  chairs.correct(shape, correction);
  CHECK(chairs.fit().fitted == 1);
  const PartTemplate used =
      chairs.project.find_template(chairs.project.fit(shape)->part_template)->part_template;
  const auto back = std::ranges::find(used.parts, "back", &TemplatePart::name) - used.parts.begin();
  for (const std::uint32_t i : correction.pinned["back"])
    CHECK(chairs.project.fit(shape)->fit.labels[i] == back);

  correction.sampling.words[0] ^= 1;
  chairs.correct(shape, correction);
  chairs.fit();
  const auto labels = chairs.project.fit(shape)->fit.labels;
  CHECK_FALSE(std::ranges::all_of(correction.pinned["back"], [&](auto i) { return labels[i] == back; }));
}

TEST_CASE("marks become the status of a fit") {
  Chairs chairs(4);
  chairs.fit();
  const auto ids = chairs.project.shape_ids();
  chairs.correct(ids[0], {.mark = ShapeMark::outlier});
  chairs.correct(ids[1], {.mark = ShapeMark::learn});
  CHECK(chairs.fit().fitted == 2);
  CHECK(chairs.project.fit(ids[0])->status == FitStatus::outlier);
  CHECK(chairs.project.fit(ids[1])->status == FitStatus::learned);
  CHECK(chairs.project.fit(ids[2])->status == FitStatus::fitted);
}

TEST_CASE("learning leaves marked outliers out, learns from what it must, and keeps pins") {
  Chairs chairs(20);
  const auto ids = chairs.project.shape_ids();
  const LearnReport free = chairs.learn();
  const auto before = learning_record(chairs.project)->judging;
  const ShapeId judge = before.front();
  chairs.correct(judge, {.mark = ShapeMark::outlier});
  const auto outside =
      std::ranges::find_if(ids, [&](ShapeId id) { return std::ranges::find(before, id) == before.end(); });
  REQUIRE(outside != ids.end());
  chairs.correct(*outside, {.yaw_quarters = 1, .mark = ShapeMark::learn});

  const LearnReport report = chairs.learn();
  const auto after = learning_record(chairs.project)->judging;
  CHECK(std::ranges::find(after, judge) == after.end());
  CHECK(report.fit.fitted == 20);
  CHECK(chairs.project.fit(judge)->status == FitStatus::outlier);
  CHECK(chairs.project.fit(*outside)->status == FitStatus::learned);
  CHECK(chairs.project.fit(*outside)->fit.yaw_quarters == 1);
  CHECK(chairs.learn().fit.kept == 20);
}

TEST_CASE("corrected fits and learning are the same for any number of threads") {
  std::vector<std::vector<std::int16_t>> labels[2];
  std::vector<PartTemplate> learned[2];
  for (const unsigned threads : {1U, 4U}) {
    Chairs chairs(12);
    const auto ids = chairs.project.shape_ids();
    chairs.correct(ids[0], {.yaw_quarters = 1});
    chairs.correct(ids[3], {.mark = ShapeMark::outlier});
    chairs.correct(ids[5], {.mark = ShapeMark::learn});
    chairs.learn(threads);
    for (const ShapeId id : ids) labels[threads == 1].push_back(*chairs.project.labels(id));
    for (const TemplateRecord& each : chairs.project.templates())
      learned[threads == 1].push_back(each.part_template);
  }
  CHECK(labels[0] == labels[1]);
  CHECK(learned[0] == learned[1]);
}

TEST_CASE("nothing can be learned where every shape is an outlier") {
  Chairs chairs(3);
  for (const ShapeId id : chairs.project.shape_ids()) chairs.correct(id, {.mark = ShapeMark::outlier});
  CHECK_THROWS_WITH_AS(chairs.learn(), doctest::Contains("outlier"), Error);
}

TEST_CASE("shapes that were corrected are fitted anew alone, as they would be with all others") {
  Chairs chairs(6);
  chairs.fit();
  const auto ids = chairs.project.shape_ids();
  const auto record = chairs.project.find_shape(ids[1]);
  chairs.correct(ids[1], {.pinned = {{"back", {0, 1, 2, 3}}}, .sampling = sampling_of(*record)});
  chairs.correct(ids[2], {.yaw_quarters = 3});
  chairs.correct(ids[3], {.mark = ShapeMark::outlier});
  chairs.correct(ids[4], {.part_template = "bench"});
  chairs.correct(ids[5], {.yaw_quarters = 1});
  const std::vector<ShapeId> meant{ids[0], ids[1], ids[2], ids[3], ids[4], 999};
  const FitCollectionReport report = fit_corrected(chairs.project, meant, 2, {});
  CHECK(report.fitted == 4);
  CHECK(report.kept == 1);
  CHECK(chairs.project.fit(ids[2])->fit.yaw_quarters == 3);
  CHECK(chairs.project.fit(ids[3])->status == FitStatus::outlier);
  CHECK(chairs.template_of(ids[4]) == "bench");
  std::vector<FitRecord> alone;
  std::vector<std::vector<std::int16_t>> labels;
  for (std::size_t i = 0; i < 5; ++i) {
    alone.push_back(chairs.project.fit(ids[i]).value());
    labels.push_back(chairs.project.labels(ids[i]).value());
  }
  CHECK(chairs.fit().fitted == 1);  // the one that was not meant
  chairs.project.clear_fits();
  chairs.project.set_setting("fit.yaw_energies", "damaged");  // they are found again
  CHECK(chairs.fit().fitted == 6);
  for (std::size_t i = 0; i < 5; ++i) {
    const FitRecord together = chairs.project.fit(ids[i]).value();
    CHECK(together.state == alone[i].state);
    CHECK(together.status == alone[i].status);
    CHECK(together.fit.labels == alone[i].fit.labels);
    CHECK(together.fit.energy == alone[i].fit.energy);
    CHECK(chairs.project.labels(ids[i]) == labels[i]);
  }
}

TEST_CASE("a correction that names what is not there leaves the fit of its shape as it is") {
  Chairs chairs(2);
  chairs.fit();
  const auto ids = chairs.project.shape_ids();
  chairs.correct(ids[0], {.part_template = "sofa"});
  chairs.correct(ids[1], {.pinned = {{"rudder", {1, 2}}}});
  const ContentHash before = chairs.project.fit(ids[0])->state;
  CHECK(fit_corrected(chairs.project, ids, 2, {}).fitted == 0);
  CHECK(chairs.project.fit(ids[0])->state == before);
  Project none = Project::in_memory();
  CHECK(fit_corrected(none, ids, 2, {}).fitted == 0);
}
