// What other shapes say of the yaw of one, as it is read again after the fit.
#include "core/session/yaw_votes.h"

#include <doctest/doctest.h>

#include "core/fitting/fit_template.h"
#include "core/session/fit_collection.h"
#include "tests/support/imported_chairs.h"

using namespace archetype;
using namespace archetype::test;

TEST_CASE("The costs of yaws that a project keeps are those that its fits were made with") {
  ImportedChairs chairs(8);
  CHECK_FALSE(kept_yaw_costs(chairs.project, chairs.project.shape_ids().front(), {}));  // nothing is fitted
  fit_collection(chairs.project, {chair_template()}, {}, 2, {});
  bool any = false;
  for (const ShapeId id : chairs.project.shape_ids()) {
    const auto costs = kept_yaw_costs(chairs.project, id, {});
    REQUIRE(costs);
    for (const double cost : *costs) any = any || cost > 0;
    FitOptions options;
    options.yaw_costs = *costs;
    const auto again = fit_template(chair_template(), chairs.project.samples(id), options);
    const auto stored = chairs.project.fit(id);
    REQUIRE(again);
    REQUIRE(stored);
    CHECK(again->yaw_quarters == stored->fit.yaw_quarters);
    CHECK(again->labels == stored->fit.labels);
    CHECK(again->energy == stored->fit.energy);
  }
  CHECK(any);
  // Of other templates nothing is known.
  PartTemplate other = chair_template();
  other.parts.front().position.mean.y() += 0.1;
  TemplateRecord record;
  record.part_template = other;
  chairs.project.set_current_templates({chairs.project.add_template(record)});
  CHECK_FALSE(kept_yaw_costs(chairs.project, chairs.project.shape_ids().front(), {}));
}
