// Each action is done, undone and redone, and must give the same documents each time.
#include "core/session/actions.h"

#include <doctest/doctest.h>

#include <functional>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/io/template_file.h"
#include "core/model/part_colours.h"

using namespace archetype;

namespace {

History history_with_two_parts() {
  PartTemplate chair;
  chair.name = "chair";
  for (const char* name : {"seat", "leg"}) {
    TemplatePart part;
    part.name = name;
    part.label = static_cast<int>(chair.parts.size());
    part.position.mean = Vec3(0.3, 0.1 * part.label, 0.2);
    chair.parts.push_back(part);
  }
  Document document;
  document.templates.push_back(std::make_shared<const PartTemplate>(chair));
  chair.name = "bench";
  document.templates.push_back(std::make_shared<const PartTemplate>(chair));
  return History(document, "Start");
}

const PartTemplate& active(const History& history) {
  return *history.current().active_template();
}

Box some_box() {
  return {Vec3(0.1, 0.2, 0.3), Vec3(0.4, 0.5, 0.6), Eigen::Quaterniond(0.6, 0, 0.8, 0)};
}

ShapeFit fit_of_two_parts() {
  ShapeFit fit;
  fit.parts = {{true, some_box()}, {false, {}}};
  for (int i = 0; i < 12; ++i) fit.labels.push_back(i < 10 ? 0 : 1);
  return fit;
}

ShapeSamples samples_of_twelve() {
  ShapeSamples samples;
  for (int i = 0; i < 12; ++i) {
    samples.points.push_back(Vec3(i, 0, 0));
    samples.features_x.push_back({i < 5 ? 0.0 : 1.0, 0.5, 0.5, 0.5, 0.5, 0.5});
  }
  samples.features_z = samples.features_x;
  return samples;
}

struct Action {
  const char* name;
  std::function<void(History&)> run;
};

std::vector<Action> all_actions() {
  return {
      {"add_template",
       [](History& h) { add_template(h, {.name = "chair", .parts = {}, .extra_json = {}}, "New"); }},
      {"duplicate_active_template", [](History& h) { duplicate_active_template(h); }},
      {"remove_active_template", [](History& h) { remove_active_template(h); }},
      {"rename_active_template", [](History& h) { rename_active_template(h, "stool"); }},
      {"select_template", [](History& h) { select_template(h, 1); }},
      {"add_part", [](History& h) { add_part(h, some_box()); }},
      {"move_active_template", [](History& h) { move_active_template(h, 1); }},
      {"duplicate_parts",
       [](History& h) {
         duplicate_parts(h, {0, 1});
       }},
      {"add_mirror_images",
       [](History& h) {
         add_mirror_images(h, {1, 0}, 0);
       }},
      {"link_parts", [](History& h) { link_parts(h, 0, 1, 2); }},
      {"remove_parts",
       [](History& h) {
         remove_parts(h, {0, 1});
       }},
      {"merge_parts",
       [](History& h) {
         merge_parts(h, {1, 0});
       }},
      {"split_part", [](History& h) { split_part(h, 0, 2); }},
      {"paste_parts", [](History& h) { paste_parts(h, {TemplatePart()}); }},
      {"set_part_boxes",
       [](History& h) {
         set_part_boxes(h, {{1, some_box()}, {0, some_box()}});
       }},
      {"rename_part", [](History& h) { rename_part(h, 0, "cushion"); }},
      {"set_part_label",
       [](History& h) {
         set_part_label(h, {1, 0}, 7);
       }},
      {"set_part_colour", [](History& h) { set_part_colour(h, {0}, 5); }},
      {"set_must_exist", [](History& h) { set_must_exist(h, {0}, true); }},
      {"set_part_box", [](History& h) { set_part_box(h, 0, some_box()); }},
      {"set_position_stddev", [](History& h) { set_position_stddev(h, {0}, Vec3(0.1, 0.1, 0.1)); }},
      {"set_scale_stddev", [](History& h) { set_scale_stddev(h, {0}, Vec3(0.3, 0.1, 0.2)); }},
      {"set_existence", [](History& h) { set_existence(h, {0}, 0.5); }},
      {"adopt_fitted_boxes", [](History& h) { adopt_fitted_boxes(h, fit_of_two_parts()); }},
      {"learn_features", [](History& h) { learn_features(h, samples_of_twelve(), fit_of_two_parts()); }},
  };
}

}  // namespace

TEST_CASE("Every action is one step that can be undone and redone") {
  for (const Action& action : all_actions()) {
    CAPTURE(action.name);
    History history = history_with_two_parts();
    const Document before = history.current();
    action.run(history);
    const Document after = history.current();
    CHECK_FALSE(after == before);
    REQUIRE(history.entries().size() == 2);
    CHECK_FALSE(history.entries()[1].message.empty());
    CHECK(history.undo());
    CHECK(history.current() == before);
    CHECK(history.redo());
    CHECK(history.current() == after);
  }
}

TEST_CASE("A drag is many live edits and one step") {
  History history = history_with_two_parts();
  Box box = some_box();
  for (int i = 0; i < 5; ++i) {
    box.centre.x() += 0.1;
    set_part_box(history, 0, box, Stage::live);
    CHECK(active(history).parts[0].position.mean == box.centre);
    CHECK(history.entries().size() == 1);
  }
  set_part_box(history, 0, box, Stage::done);
  CHECK(history.entries().size() == 2);
  history.undo();
  CHECK(active(history).parts[0].position.mean == Vec3(0.3, 0, 0.2));
}

TEST_CASE("Sizes stay positive, existence stays a probability, names stay unique") {
  History history = history_with_two_parts();
  Box flat = some_box();
  flat.half_extent = Vec3(-1, 0, 0.5);
  set_part_box(history, 0, flat);
  CHECK(active(history).parts[0].scale.mean == Vec3(min_half_extent, min_half_extent, 0.5));
  set_existence(history, {0}, -3);
  CHECK(active(history).parts[0].existence > 0);
  CHECK(duplicate_parts(history, {1}) == PartList{2});
  CHECK(duplicate_parts(history, {2}) == PartList{3});
  CHECK(active(history).parts[2].name == "leg 2");
  CHECK(active(history).parts[3].name == "leg 3");
  CHECK(active(history).parts[3].label == active(history).parts[1].label);
  rename_active_template(history, "bench");
  CHECK(active(history).name == "bench 2");
}

TEST_CASE(
    "Parts keep their colours whatever is added, split, merged or deleted before them, and new ones get "
    "others") {
  History history = history_with_two_parts();
  for (const char* name : {"back", "arm"}) add_part(history, some_box(), name);
  std::map<std::string, Rgb> before;
  const auto look = [&](const std::string& what) {
    CAPTURE(what);
    std::map<std::string, Rgb> now;
    std::set<Rgb> distinct;
    for (std::size_t i = 0; i < active(history).parts.size(); ++i) {
      const std::string& name = active(history).parts[i].name;
      CAPTURE(name);
      now[name] = part_colour(active(history), static_cast<int>(i));
      CHECK(distinct.insert(now[name]).second);
      if (before.contains(name)) CHECK(before[name] == now[name]);
    }
    before = now;
  };
  look("at first");
  split_part(history, 0, 1);
  look("split the first");
  duplicate_parts(history, {1});
  look("duplicate one in the middle");
  add_mirror_images(history, {0}, 0);
  look("mirror the first");
  split_part(history, 0, 2);
  look("split a linked one, and its image");
  remove_parts(history, {1, 2});
  look("delete in the middle");
  merge_parts(history, {1, 2});
  look("merge");
  paste_parts(history, {active(history).parts[0], active(history).parts[1]});
  look("paste");
  add_part(history, some_box(), "last");
  look("add");
}

TEST_CASE(
    "Parts in the order in which they were added have the colours of their places, of which files say "
    "nothing") {
  History history = history_with_two_parts();
  add_part(history, some_box());
  paste_parts(history, {active(history).parts[0]});
  for (const TemplatePart& part : active(history).parts) CHECK(part.colour == -1);
}

TEST_CASE("A mirrored box is the mirror image, corner by corner") {
  History history = history_with_two_parts();
  Box box = some_box();
  box.orientation = Eigen::Quaterniond(0.7, 0.3, -0.5, 0.2).normalized();
  set_part_box(history, 0, box);
  const std::size_t copy = add_mirror_images(history, {0}, 0)[0];
  const Box mirrored = active(history).parts[copy].mean_box();
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 local(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    Vec3 expected = box.to_world(local);
    expected.x() = -expected.x();
    const Vec3 reached = mirrored.to_local(expected);
    CHECK((reached.cwiseAbs() - Vec3::Ones()).norm() < 1e-9);
  }
}

TEST_CASE("Features are the mean and spread of the samples of each part") {
  History history = history_with_two_parts();
  learn_features(history, samples_of_twelve(), fit_of_two_parts());
  const PartTemplate& learned = active(history);
  CHECK(learned.parts[0].has_features);
  CHECK(learned.parts[0].features.mean[0] == doctest::Approx(0.5));
  CHECK(learned.parts[0].features.stddev[0] == doctest::Approx(0.5));
  CHECK_FALSE(learned.parts[1].has_features);  // two samples are too few
  const Document before = history.current();
  forget_features(history);
  CHECK_FALSE(active(history).parts[0].has_features);
  history.undo();
  CHECK(history.current() == before);
}

TEST_CASE("What was learned takes the place of the templates that it came of, in one step") {
  History history = history_with_two_parts();
  PartTemplate stool = *history.committed().templates[0];
  stool.name = "stool";
  add_template(history, stool, "Add");
  PartTemplate first = stool;
  first.name = "first";
  PartTemplate second = stool;
  second.name = "bench";
  const auto names = [&] {
    std::vector<std::string> result;
    for (const auto& each : history.current().templates) result.push_back(each->name);
    return result;
  };
  take_learned(history, {first, second}, std::vector<std::size_t>{0, 2}, "Learn");
  CHECK(names() == std::vector<std::string>{"first", "bench 2", "bench"});
  CHECK(active(history).name == "first");
  history.undo();
  CHECK(names() == std::vector<std::string>{"chair", "bench", "stool"});
  take_learned(history, {first}, {}, "Learn");
  CHECK(names() == std::vector<std::string>{"chair", "bench", "stool", "first"});
  CHECK(active(history).name == "first");
  CHECK_THROWS_AS(take_learned(history, {}, {}, "Learn"), PreconditionError);
}

TEST_CASE("Actions on what is not there say so and change nothing") {
  History history = history_with_two_parts();
  CHECK_THROWS_AS(remove_parts(history, {2}), PreconditionError);
  CHECK_THROWS_AS(set_part_label(history, {0}, -1), PreconditionError);
  CHECK_THROWS_AS(select_template(history, 5), PreconditionError);
  CHECK_THROWS_AS(adopt_fitted_boxes(history, {}), PreconditionError);
  CHECK(history.entries().size() == 1);
  History empty({}, "Start");
  CHECK_THROWS_AS(add_part(empty, some_box()), PreconditionError);
}

TEST_CASE("Whatever numbers are wanted, the template can be written to a file") {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double number : {infinity, -infinity, std::nan(""), 1e300, -1e300}) {
    CAPTURE(number);
    History history = history_with_two_parts();
    const Vec3 wanted(0.5, number, 0.5);
    Box box{wanted, wanted, Eigen::Quaterniond(number, 0, 0, 1)};
    set_part_box(history, 0, box);
    set_position_stddev(history, {0}, wanted);
    set_scale_stddev(history, {0}, wanted);
    set_existence(history, {0}, number);
    duplicate_parts(history, {0});
    try {
      add_mirror_images(history, {0}, 0);
    } catch (const Error&) {
      // What is as large as can be is nearly its own mirror image.
      CHECK(active(history).parts[0].scale.mean.maxCoeff() > 1e3);
      add_part(history, box);
    }
    split_part(history, 0, 1);
    merge_parts(history, {0, 1, 2});
    add_part(history, box);
    CHECK_NOTHROW(format_template(active(history)));
  }
}

TEST_CASE("A template takes as many parts as a file does") {
  History history = history_with_two_parts();
  while (active(history).parts.size() < most_template_parts) add_part(history, some_box());
  CHECK_NOTHROW(format_template(active(history)));
  const Document full = history.current();
  CHECK_THROWS_WITH_AS(add_part(history, some_box()), "a template has at most 256 parts", Error);
  CHECK_THROWS_AS(duplicate_parts(history, {0}), Error);
  CHECK_THROWS_AS(add_mirror_images(history, {0}, 0), Error);
  CHECK(history.current() == full);
}
