// Each correction in the window: done, undone, redone; the shape is fitted anew by itself each time, and the
// next fit of all finds nothing left to do.
#include <doctest/doctest.h>

#include <algorithm>
#include <functional>

#include "core/session/fit_collection.h"
#include "tests/ui/sized_project.h"
#include "tests/ui/test_window.h"
#include "ui/clusters_view.h"
#include "ui/inspect_brush.h"
#include "ui/inspection.h"
#include "ui/project_actions.h"

using namespace archetype;
using archetype::test::TestWindow;

namespace {

struct CorrectionWindow : TestWindow {
  CorrectionWindow() : TestWindow(640, 480) {
    studio().settings.show_bottom = false;
    open_project(studio(), test::make_sized_project(scratch().path(), 5));
    settle();
    run("show-inspect");
    REQUIRE(studio().inspection.main.look);
  }
  void run(const char* command, const std::vector<std::string>& arguments = {}) {
    CAPTURE(command);
    REQUIRE(run_command(studio(), command, arguments));
    settle();
  }
  FitRecord fit() { return Project::open(studio().collection.path).fit(*studio().ui.shape).value(); }
  FitSummary shown() {
    return studio().collection.rows()[*find_row(studio().collection, *studio().ui.shape)].fit.value();
  }
  std::string template_of(const FitRecord& record) {
    return Project::open(studio().collection.path).find_template(record.part_template)->part_template.name;
  }
  // What a fit of all shapes by the same templates would still change.
  std::size_t left_to_fit() {
    save_now(studio());
    Project project = Project::open(studio().collection.path);
    store_corrections(project, studio().history.committed());
    std::vector<PartTemplate> templates;
    for (const TemplateRecord& each : project.templates()) templates.push_back(each.part_template);
    return fit_collection(project, templates, {}, 2, {}).fitted;
  }
  std::string other_template() { return template_of(fit()) == "chair" ? "stool" : "chair"; }
  void paint(const std::string& part) {
    run("paint-labels", {part});
    drag("inspect:shape", 30, 10);
    settle();
    run("paint-labels");
  }
};

bool same(const FitRecord& a, const FitRecord& b) {
  return a.part_template == b.part_template && a.status == b.status && a.state == b.state &&
         a.fit.yaw_quarters == b.fit.yaw_quarters && a.fit.labels == b.fit.labels &&
         a.fit.energy == b.fit.energy;
}

bool pinned_labels_hold(CorrectionWindow& window) {
  const ShapeCorrection correction = correction_in_view(window.studio());
  const FitRecord record = window.fit();
  const auto& look = *window.studio().inspection.main.look;
  if (correction.pinned.empty()) return false;
  for (const auto& [part, samples] : correction.pinned)
    for (const std::uint32_t sample : samples) {
      const std::int16_t label = record.fit.labels[sample];
      const std::string name =
          label == null_label ? "" : look.part_template->parts[static_cast<std::size_t>(label)].name;
      if (name != part) return false;
    }
  return true;
}

struct Correction {
  std::string name;
  std::function<void(CorrectionWindow&)> prepare;  // what it takes back, if it does
  std::function<void(CorrectionWindow&)> make;
  std::function<bool(CorrectionWindow&, const FitRecord& before)> heeded;
  bool by_hand = false;  // in the view of a single fit
};

}  // namespace

TEST_CASE("Each correction is done, undone and redone, and the shape is fitted anew each time") {
  const auto nothing = [](CorrectionWindow&) {};
  const auto turn = [](CorrectionWindow& w) {
    w.run("pin-yaw", {std::to_string((w.fit().fit.yaw_quarters + 1) % 4 * 90)});
  };
  const auto turned = [](CorrectionWindow& w, const FitRecord& before) {
    return w.fit().fit.yaw_quarters == (before.fit.yaw_quarters + 1) % 4;
  };
  const auto exchange = [](CorrectionWindow& w) { w.run("pin-template", {w.other_template()}); };
  const auto exchanged = [](CorrectionWindow& w, const FitRecord& before) {
    return w.fit().part_template != before.part_template;
  };
  const auto paint = [](CorrectionWindow& w) { w.paint("leg"); };
  const auto outlier = [](CorrectionWindow& w) { w.run("mark-outlier"); };
  const auto learn = [](CorrectionWindow& w) { w.run("learn-from-shape"); };
  const auto plain = [](CorrectionWindow& w, const FitRecord&) {
    return w.fit().status == FitStatus::fitted && correction_in_view(w.studio()).empty();
  };
  const std::vector<Correction> corrections{
      {"yaw", nothing, turn, turned},
      {"template", nothing, exchange, exchanged},
      {"what is shown", nothing,
       [](CorrectionWindow& w) {
         const FitRecord now = w.fit();
         w.run("inspect-alternative",
               {std::to_string((now.fit.yaw_quarters + 1) % 4 * 90), w.other_template()});
         w.run("pin-shown");
       },
       [&](CorrectionWindow& w, const FitRecord& before) {
         return turned(w, before) && exchanged(w, before);
       },
       true},
      {"painted points", nothing, paint,
       [](CorrectionWindow& w, const FitRecord&) { return pinned_labels_hold(w); }, true},
      {"outlier", nothing, outlier,
       [](CorrectionWindow& w, const FitRecord&) { return w.fit().status == FitStatus::outlier; }},
      {"learn from it", nothing, learn,
       [](CorrectionWindow& w, const FitRecord&) { return w.fit().status == FitStatus::learned; }},
      {"free yaw", turn, [](CorrectionWindow& w) { w.run("free-yaw"); }, plain},
      {"free template", exchange, [](CorrectionWindow& w) { w.run("free-template"); }, plain},
      {"free points", paint, [](CorrectionWindow& w) { w.run("free-points"); }, plain, true},
      {"unmark", outlier, outlier, plain},
      {"clear", [&](CorrectionWindow& w) { turn(w), learn(w); },
       [](CorrectionWindow& w) { w.run("clear-corrections"); }, plain},
  };
  CorrectionWindow window;
  Studio& studio = window.studio();
  for (const Correction& correction : corrections) {
    CAPTURE(correction.name);
    // Where single fits are not shown there is less to wait for.
    window.run(correction.by_hand ? "show-inspect" : "show-plots");
    correction.prepare(window);
    const Document before = studio.history.committed();
    const FitRecord fit_before = window.fit();
    const std::size_t steps = studio.history.entries().size();
    correction.make(window);
    window.settle();
    CHECK(studio.history.entries().size() == steps + 1);
    const Document after = studio.history.committed();
    CHECK_FALSE(after == before);
    const FitRecord fit_after = window.fit();
    CHECK(correction.heeded(window, fit_before));
    CHECK(window.shown().state == fit_after.state);
    if (correction.by_hand) CHECK(outdated_fits(studio) == 0);

    window.key("Ctrl+Z");
    window.settle();
    CHECK(studio.history.committed() == before);
    CHECK(same(window.fit(), fit_before));
    window.key("Ctrl+Shift+Z");
    window.settle();
    CHECK(studio.history.committed() == after);
    CHECK(same(window.fit(), fit_after));
    CHECK(window.left_to_fit() == 0);
    CHECK(same(window.fit(), fit_after));
    if (!correction_in_view(studio).empty()) window.run("clear-corrections");
  }
}

TEST_CASE("What is marked as an outlier goes to the outliers at once, and back") {
  CorrectionWindow window;
  Studio& studio = window.studio();
  window.run("show-clusters");
  const auto outliers = [&] {
    std::size_t count = 0;
    for (const ShapeCluster& cluster : follow_clusters(studio))
      if (cluster.kind == ClusterKind::outliers) count += cluster.all;
    return count;
  };
  REQUIRE(outliers() == 0);
  window.run("mark-outlier", {studio.collection.rows()[3].name});
  CHECK(outliers() == 1);
  window.key("Ctrl+Z");
  window.settle();
  CHECK(outliers() == 0);
}

TEST_CASE("A shape that has no fit yet is not fitted by a correction, and heeds it later") {
  TestWindow window;
  window.open_chairs(1);
  window.make_template();
  Studio& studio = window.studio();
  REQUIRE(run_command(studio, "pin-yaw", std::vector<std::string>{"90"}));
  window.settle();
  CHECK_FALSE(studio.collection.rows()[0].fit);
  REQUIRE(run_command(studio, "fit-all"));
  window.settle();
  REQUIRE(studio.collection.rows()[0].fit);
  CHECK(studio.collection.rows()[0].fit->yaw_quarters == 1);
}

TEST_CASE("The brush paints what is seen, and not the other side") {
  CorrectionWindow window;
  Studio& studio = window.studio();
  const InspectSide& side = studio.inspection.main;
  InspectContent content;
  content.shape = side.shape;
  content.look = side.look;
  std::vector<std::uint32_t> all(side.shape->samples->size());
  for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
  const Viewport viewport{600, 600};
  Camera camera = studio.inspection.camera;
  look_from(camera, ViewPreset::top);
  const auto above = seen_samples(content, camera, viewport, all);
  look_from(camera, ViewPreset::bottom);
  const auto below = seen_samples(content, camera, viewport, all);
  CHECK(above.size() > 20);
  CHECK(below.size() > 20);
  // Upright surfaces are seen from neither; few samples on edges from both.
  std::vector<std::uint32_t> both;
  std::ranges::set_intersection(above, below, std::back_inserter(both));
  CHECK(both.size() < all.size() / 4);
  CHECK(both.size() < std::min(above.size(), below.size()));
}
