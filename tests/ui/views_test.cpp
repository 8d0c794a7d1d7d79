// What the shape in view is drawn with: the heat map, the average of the collection behind it.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/ui/test_window.h"
#include "ui/command.h"
#include "ui/project_actions.h"

using namespace archetype;
using test::TestWindow;

TEST_CASE("H colours the shape in view by how badly it is explained, and back") {
  TestWindow window;
  window.open_chairs(1);
  window.make_template();
  const ViewportState& state = window.studio().viewport;
  const auto by_part = state.colours.elements;
  const Picture before = window.window().picture();
  window.key("H");
  window.settle();
  const ViewFit& fit = *window.studio().shape.fit;
  REQUIRE(fit.element_costs.size() == window.studio().shape.mesh->face_count());
  CHECK(*state.colours.elements != *by_part);
  CHECK_FALSE(window.window().picture() == before);
  const auto worst = std::ranges::max_element(fit.element_costs) - fit.element_costs.begin();
  const auto best = std::ranges::min_element(fit.element_costs) - fit.element_costs.begin();
  CHECK((*state.colours.elements)[static_cast<std::size_t>(worst)][0] >
        (*state.colours.elements)[static_cast<std::size_t>(best)][0]);
  window.key("H");
  window.settle();
  CHECK(*state.colours.elements == *by_part);
}

TEST_CASE("O puts the average of the collection behind the shape, turned as the shapes are fitted") {
  TestWindow window;
  window.open_chairs(6);
  window.make_template();
  const ViewportState& state = window.studio().viewport;
  const Picture before = window.window().picture();
  window.key("O");
  window.settle();
  REQUIRE(state.average);
  CHECK(state.average->shapes == 6);
  REQUIRE(state.average->points->positions.size() > 50);
  CHECK(state.average->over_dark->size() == state.average->points->positions.size());
  CHECK_FALSE(window.window().picture() == before);
  // Chairs stand on their legs: there is something at the height of the seat, and most of it is drawn last.
  const auto lightness = [&](std::size_t i) { return (*state.average->over_dark)[i][0]; };
  CHECK(lightness(0) <= lightness(state.average->points->positions.size() - 1));
  const std::uint64_t revision = state.average->revision;
  REQUIRE(run_command(window.studio(), "fit-all"));
  window.settle();
  CHECK(state.average->revision != revision);  // made anew of the fits
  window.key("O");
  window.settle();
  CHECK_FALSE(window.studio().ui.view.average);
}

TEST_CASE("The average is clearly seen beside and over the shape, dark and light") {
  for (const char* theme : {"theme-dark", "theme-light"}) {
    CAPTURE(theme);
    TestWindow window;
    window.open_chairs(8);
    REQUIRE(run_command(window.studio(), theme));
    window.settle();
    const Picture before = window.window().picture();
    window.key("O");
    window.settle();
    const Picture after = window.window().picture();
    std::size_t clear = 0;  // pixels that differ by more than an eighth of what they can
    for (std::size_t i = 0; i + 2 < after.pixels.size(); i += 4) {
      int most = 0;
      for (std::size_t k = 0; k < 3; ++k)
        most = std::max(most, std::abs(after.pixels[i + k] - before.pixels[i + k]));
      clear += most > 32;
    }
    CHECK(clear > after.pixels.size() / 4 / 100);
  }
}

TEST_CASE("The tool bar of a small window has all tools, and the switches of what is drawn") {
  TestWindow window(1280, 720);
  window.open_chairs(1);
  window.make_template();
  window.settle();
  for (const char* command : {"tool-move", "tool-scale", "tool-rotate", "snapping", "surface", "wireframe",
                              "points", "part-colours", "boxes", "fitted-boxes"}) {
    CAPTURE(command);
    CHECK(std::ranges::any_of(window.studio().targets, [&](const Target& target) {
      return target.name == std::string("command:") + command;
    }));
  }
}

TEST_CASE("In narrow side panels nothing lies over another, and the search has room for a word") {
  TestWindow window(1280, 720);
  window.open_chairs(1);
  window.make_template();
  window.studio().settings.left_width = 150;
  window.studio().settings.right_width = 200;
  window.settle();
  const auto place_of = [&](const std::string& name) {
    const auto at = std::ranges::find(window.studio().targets, name, &Target::name);
    REQUIRE_MESSAGE(at != window.studio().targets.end(), name);
    return *at;
  };
  CHECK(place_of("grid:filter").high_x - place_of("grid:filter").low_x > 90);
  CHECK(place_of("grid:filter").high_x <= 150);
  for (const char* target : {"grid:order", "command:show-filter"}) CHECK(place_of(target).high_x <= 150);
  for (const char* target :
       {"template:choose", "template:more", "command:mirror-part", "command:delete-part"})
    CHECK(place_of(target).high_x <= 1280);
  std::vector<Target> yaws;
  for (const char* yaw : {"0", "90", "180", "270"}) yaws.push_back(place_of(std::string("fit:yaw:") + yaw));
  for (std::size_t i = 0; i < yaws.size(); ++i) {
    CHECK(yaws[i].high_x <= 1280);
    for (std::size_t k = i + 1; k < yaws.size(); ++k)
      CHECK((yaws[i].high_x <= yaws[k].low_x || yaws[i].high_y <= yaws[k].low_y ||
             yaws[k].high_x <= yaws[i].low_x));
  }
}

TEST_CASE(
    "A shape that is larger than the one before is brought into the picture, unless a detail is looked at") {
  TestWindow window(1280, 720);
  Studio& studio = window.studio();
  const auto folder = window.scratch().path() / "two";
  std::filesystem::create_directories(folder);
  const auto write_block = [&](const char* name, double width, double height) {
    std::ofstream file(folder / name);
    for (int i = 0; i < 8; ++i)
      file << "v " << ((i & 1) != 0 ? width : -width) << ' ' << ((i & 2) != 0 ? height : 0) << ' '
           << ((i & 4) != 0 ? width : -width) << '\n';
    file << "f 1 2 4 3\nf 5 6 8 7\nf 1 2 6 5\nf 3 4 8 7\nf 1 3 7 5\nf 2 4 8 6\n";
  };
  write_block("low.obj", 1, 0.3);
  write_block("tall.obj", 0.1, 3);
  open_folder(studio, folder);
  window.settle();
  const auto open = [&](const std::string& name) {
    REQUIRE(run_command(studio, "open-shape", Arguments(&name, 1)));
    window.settle();
  };
  const auto whole = [&] {
    const auto extent = shape_extent(studio.viewport.display, studio.shape.fit.get());
    REQUIRE(extent);
    const auto at = std::ranges::find(studio.targets, "viewport", &Target::name);
    REQUIRE(at != studio.targets.end());
    std::vector<glm::vec3> corners;
    for (int i = 0; i < 8; ++i)
      corners.emplace_back((i & 1) != 0 ? extent->second.x : extent->first.x,
                           (i & 2) != 0 ? extent->second.y : extent->first.y,
                           (i & 4) != 0 ? extent->second.z : extent->first.z);
    return shows_all(studio.viewport.pane().camera,
                     {static_cast<int>(at->high_x - at->low_x), static_cast<int>(at->high_y - at->low_y)},
                     corners);
  };
  open("low");
  REQUIRE(run_command(studio, "frame"));
  window.settle();
  const double close = studio.viewport.pane().camera.distance;
  open("tall");
  CHECK(whole());
  CHECK(studio.viewport.pane().camera.distance > 1.3 * close);
  open("low");  // there is room for it: nothing moves
  CHECK(studio.viewport.pane().camera.distance > 1.3 * close);

  studio.viewport.pane().camera.distance = 0.2 * close;  // a detail
  window.settle();
  open("tall");
  CHECK(studio.viewport.pane().camera.distance == 0.2 * close);
  CHECK_FALSE(whole());
}

TEST_CASE(
    "The first shape is brought into the picture, though the boxes of a template were there before it") {
  TestWindow window(1280, 720);
  Studio& studio = window.studio();
  PartTemplate small;
  small.name = "small";
  TemplatePart part;
  part.name = "middle";
  part.scale.mean = Vec3(0.2, 0.2, 0.2);
  small.parts.push_back(part);
  add_template(studio.history, small, "Make a small one");
  window.settle();
  window.open_chairs(1);
  const auto extent = shape_extent(studio.viewport.display, studio.shape.fit.get());
  REQUIRE(extent);
  const auto at = std::ranges::find(studio.targets, "viewport", &Target::name);
  REQUIRE(at != studio.targets.end());
  const std::vector<glm::vec3> corners{glm::vec3(extent->first), glm::vec3(extent->second)};
  CHECK(shows_all(studio.viewport.pane().camera,
                  {static_cast<int>(at->high_x - at->low_x), static_cast<int>(at->high_y - at->low_y)},
                  corners));
}

TEST_CASE("All that shows what a template does fits into a small window, dark and light, at both scales") {
  for (const float scale : {1.0F, 2.0F}) {
    TestWindow window(static_cast<int>(1280 * scale), static_cast<int>(720 * scale), scale);
    window.open_chairs(10);
    window.make_template();
    window.studio().ui.part = 1;
    for (const char* command : {"theme-light", "four-views", "spread", "average", "heat-map", "strip"})
      REQUIRE(run_command(window.studio(), command));
    window.settle();
    const Target* last = nullptr;
    for (const Target& target : window.studio().targets) {
      if (target.name.starts_with("tile:")) last = &target;
      if (!target.name.starts_with("tile") && !target.name.starts_with("pane:")) continue;
      CAPTURE(target.name);
      CHECK(target.high_x <= 1280 * scale);
      CHECK(target.high_y <= 720 * scale);
    }
    REQUIRE(last);  // eight of them side by side
    CHECK(last->high_x > 600 * scale);
    for (const char* pane : {"pane:Perspective", "pane:Top", "pane:Front", "pane:Right"})
      CHECK(window.has(pane));
  }
}

TEST_CASE("What was chosen in the explorer's views is kept in the settings, and shown by the next window") {
  Settings kept;
  {
    TestWindow window;
    for (const char* command : {"map-lasso", "map-pictures", "map-sliders", "inspect-mean-boxes",
                                "inspect-fitted-boxes", "inspect-correspondences"})
      REQUIRE(run_command(window.studio(), command));
    REQUIRE(run_command(window.studio(), "show-plot", std::vector<std::string>{"energies"}));
    REQUIRE(run_command(window.studio(), "inspect-colour", std::vector<std::string>{"features"}));
    window.open_chairs(1);  // another project, the same choices
    kept = window.studio().settings;
  }
  TestWindow window;
  window.studio().settings = kept;
  window.frames(2);
  const UiState& ui = window.studio().ui;
  CHECK(ui.map.tool == MapTool::lasso);
  CHECK_FALSE(ui.map.pictures);
  CHECK_FALSE(ui.map.sliders);
  CHECK(ui.plots.chosen == "energies");
  CHECK(ui.inspect.colour == InspectColour::features);
  CHECK(ui.inspect.mean_boxes);
  CHECK_FALSE(ui.inspect.fitted_boxes);
  CHECK(ui.inspect.correspondences);
  CHECK_FALSE(ui.inspect.samples);
}
