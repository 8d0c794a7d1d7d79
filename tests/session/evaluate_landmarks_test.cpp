#include "core/session/evaluate_landmarks.h"

#include <doctest/doctest.h>

#include "core/session/fit_collection.h"
#include "core/session/import_shapes.h"
#include "tests/support/made_shapes.h"
#include "tests/support/scratch_folder.h"

using namespace archetype;
using namespace archetype::test;

namespace {

LandmarkEvaluation evaluate(const std::string& family, const std::string& style) {
  const ScratchFolder folder;
  GenerateOptions options;
  options.styles = {style};
  options.count = 6;
  options.yaw = YawChoice::quarters;
  write_collection(family, options, folder.path(), {});
  Project project = Project::in_memory();
  import_shapes(project, {folder.path() / "shapes"}, {}, {});
  options.yaw = YawChoice::none;
  fit_collection(project, {template_from(make_shape(family, options, 0))}, {}, 2, {});
  return evaluate_landmarks(project, folder.path() / "landmarks", 2, {});
}

}  // namespace

TEST_CASE("landmarks of shapes that look the same turned count by the best of these turns") {
  const LandmarkEvaluation pendants = evaluate("lamps", "pendant");
  CHECK(pendants.turnable == 6);
  CHECK(pendants.all.by_diameter.count() == 6 * 5 * 9);
  CHECK(pendants.all.by_diameter.count() == pendants.as_marked.by_diameter.count());
  CHECK(pendants.all.by_diameter.within(10) > 0.8);
  CHECK(pendants.as_marked.by_diameter.within(10) < 0.7);
}

TEST_CASE("landmarks of shapes with a front count as they are marked") {
  const LandmarkEvaluation chairs = evaluate("chairs", "plain");
  CHECK(chairs.turnable == 0);
  CHECK(chairs.all == chairs.as_marked);
  CHECK(chairs.all.by_diameter.within(10) > 0.8);
}
