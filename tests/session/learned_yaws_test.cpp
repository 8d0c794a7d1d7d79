#include "core/session/learned_yaws.h"

#include <doctest/doctest.h>

#include "core/session/fit_collection.h"
#include "tests/support/imported_chairs.h"

using namespace archetype;
using namespace archetype::test;

namespace {

struct Chairs : ImportedChairs {
  Chairs() : ImportedChairs(8) {}
  std::vector<int> fitted_yaws(const PartTemplate& part_template) {
    fit_collection(project, {part_template}, {}, 2, {});
    std::vector<int> yaws;
    for (const FitSummary& fit : project.fits()) yaws.push_back(fit.yaw_quarters);
    project.clear_fits();
    return yaws;
  }
  std::vector<TemplateId> templates() const {
    std::vector<TemplateId> ids;
    for (const TemplateRecord& each : project.templates()) ids.push_back(each.id);
    return ids;
  }
  void keep(const std::vector<int>& yaws) {
    keep_learned_yaws(project, templates(), project.shape_ids(), yaws);
  }
};

std::vector<int> turned_round(std::vector<int> yaws) {
  for (int& yaw : yaws) yaw = (yaw + 2) % 4;
  return yaws;
}

}  // namespace

TEST_CASE("shapes stand as they did when learning began, unless the templates clearly say otherwise") {
  Chairs chairs;
  const std::vector<int> of_drum = chairs.fitted_yaws(drum_template());
  chairs.keep(turned_round(of_drum));
  CHECK(chairs.fitted_yaws(drum_template()) == turned_round(of_drum));
  const std::vector<int> of_chair = chairs.fitted_yaws(chair_template());
  chairs.keep(turned_round(of_chair));
  CHECK(chairs.fitted_yaws(chair_template()) == of_chair);
}

TEST_CASE("known yaws are those of these templates, and of shapes as they were sampled then") {
  Chairs chairs;
  chairs.fitted_yaws(chair_template());
  CHECK(learned_yaws(chairs.project, chairs.templates()).empty());
  const std::vector<ShapeId> ids = chairs.project.shape_ids();
  const std::vector<int> yaws{0, 1, 2, 3, 0, 1, 2, 3};
  chairs.keep(yaws);
  const KnownYaws known = learned_yaws(chairs.project, chairs.templates());
  REQUIRE(known.size() == ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i) CHECK(known.at(ids[i]) == yaws[i]);
  CHECK(learned_yaws(chairs.project, {}).empty());
  CHECK(learned_yaws(chairs.project, {chairs.templates()[0] + 1}).empty());
  ImportOptions other;
  other.points = 150;
  other.seed = 7;
  chairs.import(other);
  CHECK(learned_yaws(chairs.project, chairs.templates()).empty());
}

TEST_CASE("damaged yaws are none") {
  Chairs chairs;
  chairs.fitted_yaws(chair_template());
  const std::string id = std::to_string(chairs.templates()[0]);
  for (const std::string& text :
       {std::string(), std::string("{"), std::string("[]"), R"({"templates":[)" + id + "]}",
        R"({"templates":[)" + id + R"(],"yaws":5})", R"({"templates":[)" + id + R"(],"yaws":[{"shape":1}]})",
        R"({"templates":[)" + id + R"(],"yaws":[{"shape":1,"yaw":4294967297,"sampling":"x"}]})"}) {
    chairs.project.set_setting("learn.yaws", text);
    CHECK(learned_yaws(chairs.project, chairs.templates()).empty());
  }
}
