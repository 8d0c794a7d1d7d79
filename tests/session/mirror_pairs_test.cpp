// Pairs of mirror images: kept in step by every edit until they are unlinked.
#include "core/session/mirror_pairs.h"

#include <doctest/doctest.h>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/io/template_file.h"
#include "core/learning/mirror_symmetry.h"
#include "core/session/actions.h"

using namespace archetype;

namespace {

TemplatePart made_part(const char* name, const Vec3& centre) {
  TemplatePart part;
  part.name = name;
  part.position.mean = centre;
  part.scale.mean = Vec3(0.1, 0.3, 0.2);
  part.orientation = Eigen::Quaterniond(0.9, 0.1, -0.3, 0.2).normalized();
  return part;
}

History history_of(std::vector<TemplatePart> parts) {
  PartTemplate chair;
  chair.name = "chair";
  chair.parts = std::move(parts);
  Document document;
  document.templates.push_back(std::make_shared<const PartTemplate>(chair));
  return History(document, "Start");
}

const PartTemplate& active(const History& history) {
  return *history.current().active_template();
}

bool in_step(const PartTemplate& part_template, std::size_t a, std::size_t b) {
  const TemplatePart& first = part_template.parts[a];
  const TemplatePart& second = part_template.parts[b];
  return mirror_partner(part_template, a) == b && mirror_partner(part_template, b) == a &&
         box_distance(mirrored(first.mean_box(), first.mirror.axis), second.mean_box()) < 1e-12 &&
         first.position.stddev == second.position.stddev && first.scale.stddev == second.scale.stddev &&
         first.existence == second.existence && first.must_exist == second.must_exist;
}

Box some_box() {
  return {Vec3(-0.4, 0.2, 0.3), Vec3(0.4, 0.5, 0.6), Eigen::Quaterniond(0.6, 0, 0.8, 0)};
}

}  // namespace

TEST_CASE("a mirror image follows every edit of its original, and the other way round, also in previews") {
  for (const int axis : {0, 2}) {
    History history = history_of({made_part("left leg", {0.5, -1, 0.4})});
    CHECK(add_mirror_images(history, {0}, axis) == PartList{1});
    CHECK(active(history).parts[1].name == "right leg");
    CHECK(in_step(active(history), 0, 1));
    set_part_box(history, 0, some_box(), Stage::live);
    CHECK(in_step(active(history), 0, 1));
    set_part_box(history, 1, some_box());
    CHECK(active(history).parts[1].position.mean == some_box().centre);
    CHECK(in_step(active(history), 0, 1));
    set_position_stddev(history, {1}, Vec3(0.3, 0.2, 0.1));
    set_scale_stddev(history, {0}, Vec3(0.03, 0.02, 0.01));
    set_existence(history, {1}, 0.5);
    set_must_exist(history, {0}, true);
    CHECK(in_step(active(history), 0, 1));
    set_part_label(history, {0}, 7);
    CHECK(active(history).parts[1].label == 0);
    unlink_parts(history, {1});
    set_part_box(history, 0, made_part("", {1, 1, 1}).mean_box());
    CHECK(active(history).parts[1].position.mean == some_box().centre);
  }
}

TEST_CASE("of two linked parts that are moved together the one named first leads") {
  History history = history_of({made_part("leg", {0.5, -1, 0.4})});
  add_mirror_images(history, {0}, 0);
  Box moved = active(history).parts[1].mean_box();
  moved.centre.x() += 0.1;
  set_part_boxes(history, {{1, moved}, {0, some_box()}});
  CHECK(active(history).parts[1].position.mean.x() == doctest::Approx(-0.4));
  CHECK(in_step(active(history), 0, 1));
}

TEST_CASE("what lies in the plane, or is linked already, is not mirrored") {
  TemplatePart seat = made_part("seat", {0, 0, 0});
  seat.orientation = Eigen::Quaterniond::Identity();
  History history = history_of({seat, made_part("leg", {0.5, -1, 0.4})});
  CHECK_THROWS_AS(add_mirror_images(history, {0}, 0), Error);
  CHECK(add_mirror_images(history, {0, 1}, 0) == PartList{2});
  CHECK_THROWS_AS(add_mirror_images(history, {1, 2}, 0), Error);
  CHECK(history.entries().size() == 2);
}

TEST_CASE("a pair that loses one part is none; copies of both are a pair of their own") {
  History history = history_of({made_part("leg", {0.5, -1, 0.4})});
  add_mirror_images(history, {0}, 0);
  CHECK(duplicate_parts(history, {0, 1}) == PartList{2, 3});
  CHECK(in_step(active(history), 2, 3));
  CHECK(in_step(active(history), 0, 1));
  CHECK(duplicate_parts(history, {0}) == PartList{1});
  CHECK(active(history).parts[1].mirror.pair == 0);
  remove_parts(history, {0});
  CHECK(active(history).parts[1].mirror.pair == 0);
  const std::vector<TemplatePart> copied = active(history).parts;
  paste_parts(history, copied);
  CHECK(in_step(active(history), 6, 7));
  CHECK(in_step(active(history), 2, 3));
}

TEST_CASE("split and merge take the mirror image along, and are each other's inverse") {
  for (const std::size_t which : {0, 1}) {
    History history = history_of({made_part("leg", {0.5, -1, 0.4})});
    add_mirror_images(history, {0}, 0);
    const Box whole = active(history).parts[which].mean_box();
    const PartList halves = split_part(history, which, 1);
    REQUIRE(active(history).parts.size() == 4);
    const Box lower = active(history).parts[halves[0]].mean_box();
    const Box upper = active(history).parts[halves[1]].mean_box();
    CHECK((lower.to_world({1, -1, 1}) - whole.to_world({1, -1, 1})).norm() < 1e-12);
    CHECK((upper.to_world({1, 1, 1}) - whole.to_world({1, 1, 1})).norm() < 1e-12);
    CHECK((upper.to_world({1, -1, 1}) - whole.to_world({1, 0, 1})).norm() < 1e-12);
    for (const std::size_t half : halves) {
      const auto partner = mirror_partner(active(history), half);
      REQUIRE(partner);
      CHECK(in_step(active(history), half, *partner));
    }
    const std::size_t merged = merge_parts(history, halves);
    REQUIRE(active(history).parts.size() == 2);
    CHECK(box_distance(active(history).parts[merged].mean_box(), whole) < 1e-9);
    CHECK(in_step(active(history), 0, 1));
  }
}

TEST_CASE("merging a pair gives one part without a link") {
  History history = history_of({made_part("leg", {0.5, -1, 0.4}), made_part("back", {0, 1, 0})});
  add_mirror_images(history, {0}, 0);
  CHECK(merge_parts(history, {1, 0}) == 0);
  CHECK(active(history).parts.size() == 2);
  CHECK(active(history).parts[0].mirror.pair == 0);
  CHECK(active(history).parts[0].name == "leg 2");
  CHECK_THROWS_AS(merge_parts(history, {1}), Error);
}

TEST_CASE("whatever is done, links stay between two parts that are in step, and survive the file") {
  RandomStream random(5);
  History history = history_of({made_part("leg", {0.5, -1, 0.4}), made_part("arm", {0.7, 0.3, 0})});
  for (int round = 0; round < 600; ++round) {
    const std::size_t count = active(history).parts.size();
    const auto any = [&] { return static_cast<std::size_t>(random.uniform() * static_cast<double>(count)); };
    if (count > 20) remove_parts(history, {any(), any(), any()});
    if (count < 3) add_part(history, some_box());
    if (count > 20 || count < 3) continue;
    try {
      switch (static_cast<int>(random.uniform() * 9)) {
        case 0:
          duplicate_parts(history, {any(), any()});
          break;
        case 1:
          add_mirror_images(history, {any(), any()}, random.uniform() < 0.5 ? 0 : 2);
          break;
        case 2:
          split_part(history, any(), static_cast<int>(random.uniform() * 3));
          break;
        case 3:
          merge_parts(history, {any(), any()});
          break;
        case 4:
          remove_parts(history, {any()});
          break;
        case 5:
          if (const auto a = any(); a != 0) link_parts(history, a, 0, 0);
          break;
        case 6:
          unlink_parts(history, {any()});
          break;
        case 7: {
          Box box = some_box();
          box.centre.x() += random.uniform();
          set_part_box(history, any(), box);
          break;
        }
        default:
          paste_parts(history, {active(history).parts[any()], active(history).parts[any()]});
      }
    } catch (const Error&) {
    }
    const PartTemplate& now = active(history);
    for (std::size_t i = 0; i < now.parts.size(); ++i) {
      const auto partner = mirror_partner(now, i);
      CHECK((now.parts[i].mirror.pair > 0) == partner.has_value());
      if (partner) CHECK(in_step(now, i, *partner));
    }
    CHECK(parse_template(format_template(now), "t.json") == now);
  }
}
