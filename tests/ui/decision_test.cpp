// What a shape's fit is decided by is what the table of templates and yaws shows, or the reason is told.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "tests/ui/sized_project.h"
#include "tests/ui/test_window.h"
#include "ui/inspection.h"
#include "ui/project_actions.h"

using namespace archetype;
using archetype::test::TestWindow;

namespace {

struct DecisionWindow : TestWindow {
  DecisionWindow() : TestWindow(960, 640) {
    open_project(studio(), test::make_sized_project(scratch().path(), 12));
    settle();
    run("show-inspect");
  }
  void run(const char* command, const std::vector<std::string>& arguments = {}) {
    CAPTURE(command);
    REQUIRE(run_command(studio(), command, arguments));
    settle();
  }
  const Alternatives& alternatives() {
    const Alternatives* all = alternatives_of_view(studio());
    REQUIRE(all);
    return *all;
  }
  const FitRecord& stored() { return studio().inspection.main.shape->fit.value(); }
  bool is_stored(const FitAlternative& each) {
    return alternatives().of.shape->templates[each.part_template].id == stored().part_template &&
           each.fit.yaw_quarters == stored().fit.yaw_quarters;
  }
  std::string why() { return why_decided(alternatives(), correction_in_view(studio())); }
};

}  // namespace

TEST_CASE("The least number of the table is the fit of the project, or the reason is told") {
  DecisionWindow window;
  Studio& studio = window.studio();
  std::size_t least_is_stored = 0;
  for (const ShapeRow& row : studio.collection.rows()) {
    CAPTURE(row.name);
    window.run("select-shape", {row.name});
    const Alternatives& all = window.alternatives();
    REQUIRE(all.yaw_costs);
    const ShapeCorrection none;
    const FitAlternative* decided = decided_alternative(all, none);
    REQUIRE(decided);
    CHECK(window.is_stored(*decided));
    const auto least = std::ranges::min_element(
        all.fits, {}, [&](const FitAlternative& each) { return deciding_energy(all, each, none); });
    const bool same = window.is_stored(*least);
    least_is_stored += same;
    const bool outlier = row.fit->status == FitStatus::outlier;
    CHECK(window.why().empty() == (same && !outlier));
    if (outlier) CHECK(window.why().find("outlier") != std::string::npos);
  }
  CHECK(2 * least_is_stored > studio.collection.rows().size());
}

TEST_CASE("Where what was pinned is not the least, the panel says so") {
  DecisionWindow window;
  const int before = window.stored().fit.yaw_quarters;
  window.run("pin-yaw", {std::to_string((before + 1) % 4 * 90)});
  CHECK(window.stored().fit.yaw_quarters == (before + 1) % 4);
  CHECK(window.why().find("is not what was pinned") != std::string::npos);
  window.run("undo");
  CHECK(window.why().find("pinned") == std::string::npos);
}

TEST_CASE("A project that keeps no votes shows the fits alone, and the shape keeps its yaw") {
  DecisionWindow window;
  Alternatives all = window.alternatives();
  all.yaw_costs.reset();
  const FitAlternative* decided = decided_alternative(all, {});
  REQUIRE(decided);
  CHECK(decided->fit.yaw_quarters == window.stored().fit.yaw_quarters);
  CHECK(deciding_energy(all, *decided, {}) == decided->choice);
  // Yaws that other shapes rule out are not taken.
  all.yaw_costs = std::array<double, 4>{};
  (*all.yaw_costs)[static_cast<std::size_t>(decided->fit.yaw_quarters)] = INFINITY;
  const FitAlternative* other = decided_alternative(all, {});
  REQUIRE(other);
  CHECK(other->fit.yaw_quarters != decided->fit.yaw_quarters);
}
