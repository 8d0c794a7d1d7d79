// Figures and the report from the window's commands.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include "core/base/error.h"
#include "core/io/file.h"
#include "core/session/fit_collection.h"
#include "core/session/import_shapes.h"
#include "core/session/measure_starts.h"
#include "tests/support/small_collection.h"
#include "tests/ui/test_window.h"
#include "ui/figure.h"
#include "ui/figure_scenes.h"
#include "ui/project_actions.h"

using namespace archetype;
using test::TestWindow;

namespace {

void show_fitted_chairs(TestWindow& window, std::size_t count) {
  const auto folder = window.scratch().path();
  test::write_chairs(folder / "made", count);
  {
    Project project = Project::create(folder / "fitted.archetype");
    ImportOptions options;
    options.points = 150;
    import_shapes(project, {folder / "made" / "shapes"}, options, {});
    fit_collection(project, {test::chair_template()}, {}, 2, {});
    project.set_fit_status(project.shape_ids().back(), FitStatus::outlier);
  }
  open_project(window.studio(), folder / "fitted.archetype");
  window.settle();
}

// The width in a PNG file's header.
int png_width(const std::filesystem::path& file) {
  const std::string bytes = read_file(file);
  REQUIRE(bytes.size() > 200);
  REQUIRE(bytes.substr(1, 3) == "PNG");
  int width = 0;
  for (std::size_t i = 16; i < 20; ++i) width = width << 8 | static_cast<unsigned char>(bytes[i]);
  return width;
}

FigureRequest request_of(TestWindow& window, int width, bool transparent) {
  const Studio& studio = window.studio();
  FigureRequest request;
  request.project = studio.collection.path;
  request.shaders = studio.options.shaders;
  request.options = {width, transparent};
  for (const ShapeRow& row : studio.collection.rows()) request.shapes.push_back(row.id);
  return request;
}

}  // namespace

TEST_CASE(
    "A part that most shapes lack is a dashed outline in pictures of its template, unless it is chosen") {
  PartTemplate parts;
  parts.parts.resize(3);
  for (std::size_t i = 0; i < 3; ++i) parts.parts[i].position.mean = Vec3(3.0 * static_cast<double>(i), 0, 0);
  CHECK(template_scene(parts).boxes[1].dash == 0);
  parts.parts[1].existence = 0.2;
  const Scene scene = template_scene(parts);
  CHECK(scene.boxes[1].dash > 0);
  CHECK(scene.boxes[1].fill == 0);
  for (const std::size_t other : {0U, 2U}) CHECK(scene.boxes[other].dash == 0);
  // Its spread has gone, and no other.
  REQUIRE(scene.ellipsoids.size() == 2);
  CHECK(scene.ellipsoids[1].axes.centre == parts.parts[2].position.mean);
  REQUIRE(scene.lines.size() == 12);
  for (std::size_t i = 6; i < 12; ++i) CHECK(scene.lines[i].to.x > 5);
  CHECK(template_scene(parts, {.spread = false}).boxes[1].dash > 0);
  const Scene chosen = template_scene(parts, {.highlighted = 1});
  CHECK(chosen.boxes[1].dash == 0);
  CHECK(chosen.ellipsoids.size() == 3);
  parts.parts[1].must_exist = true;
  CHECK(template_scene(parts).boxes[1].dash == 0);
}

TEST_CASE("Each figure is saved by its command, as wide as asked for") {
  TestWindow window(500, 400);
  show_fitted_chairs(window, 3);
  for (const std::string name :
       {"figure-templates", "figure-clusters", "figure-members", "figure-coalignment", "figure-fit"}) {
    CAPTURE(name);
    const auto file = window.scratch().path() / (name + ".png");
    REQUIRE(run_command(window.studio(), name, std::vector<std::string>{file.string(), "300"}));
    window.settle();
    CHECK(png_width(file) == 300);
  }
}

TEST_CASE(
    "The figure of the clouds has the colours of the view, and tells what they mean and of what they are") {
  TestWindow window(500, 400);
  show_fitted_chairs(window, 4);
  Studio& studio = window.studio();
  FigureRequest request = request_of(window, 400, false);
  std::vector<Picture> drawn;
  std::vector<std::string> saved;
  for (const auto& [command, colour] :
       {std::pair("cloud-by-part", CloudColour::part), std::pair("cloud-by-shape", CloudColour::shape),
        std::pair("cloud-by-displacement", CloudColour::displacement)}) {
    request.cloud_colour = colour;
    drawn.push_back(coalignment_figure(request, {}).value());
    REQUIRE(run_command(studio, command));
    const auto file = window.scratch().path() / "cloud.png";
    REQUIRE(run_command(studio, "figure-coalignment", std::vector<std::string>{file.string(), "400"}));
    window.settle();
    saved.push_back(read_file(file));
    for (std::size_t i = 0; i + 1 < drawn.size(); ++i) {
      CHECK_FALSE(drawn[i] == drawn.back());
      CHECK(saved[i] != saved.back());
    }
  }
  CHECK(drawn[0].height > drawn[1].height);  // a legend stands below
  CHECK(drawn[2].height > drawn[1].height);
  // Of one template it bears its name, of more what it was told.
  const Picture of_template = drawn.back();
  request.cloud_of = "Seats of another name";
  const auto named = coalignment_figure(request, {});
  request.outliers = 3;
  const auto counted = coalignment_figure(request, {});
  REQUIRE(named);
  REQUIRE(counted);
  CHECK_FALSE(of_template == *named);
  CHECK_FALSE(*named == *counted);
}

namespace {

// A box of the size, as the part of a template and as a cloud.
PartTemplate slab(const Vec3& half_extent) {
  PartTemplate part_template;
  part_template.parts.resize(1);
  part_template.parts[0].scale.mean = half_extent;
  return part_template;
}

void check_framed(const FigureRequest& request, const Scene& scene, double width, double height) {
  FigurePage page(request);
  page.set_height(height);
  REQUIRE(
      page.draw_scene(scene, figure_camera(scene, page.viewport(width, height)), 0, 0, width, height, {}));
  const Picture& picture = page.picture();
  const int cell_width = page.viewport(width, height).width;
  int left = cell_width;
  int right = -1;
  int top = picture.height;
  int bottom = -1;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < cell_width; ++x) {
      if (picture.pixels[4 * static_cast<std::size_t>(y * picture.width + x) + 3] < 40) continue;
      left = std::min(left, x);
      right = std::max(right, x);
      top = std::min(top, y);
      bottom = std::max(bottom, y);
    }
  CAPTURE(left);
  CAPTURE(right);
  CAPTURE(top);
  CAPTURE(bottom);
  // Nothing is cut.
  CHECK(left > 0);
  CHECK(top > 0);
  CHECK(right < cell_width - 1);
  CHECK(bottom < picture.height - 1);
  // It fills one of the two directions, and stands in the middle.
  const double wide = (right - left + 1.0) / cell_width;
  const double tall = (bottom - top + 1.0) / picture.height;
  CHECK(std::max(wide, tall) > 0.8);
  CHECK(std::abs(left + right - cell_width + 1) < 0.12 * cell_width);
  CHECK(std::abs(top + bottom - picture.height + 1) < 0.12 * picture.height);
}

}  // namespace

TEST_CASE("What a figure shows fills its place, is not cut, and stands in its middle") {
  TestWindow window(300, 200);
  show_fitted_chairs(window, 2);
  FigureRequest request = request_of(window, 400, true);
  std::vector<Scene> scenes;
  for (const Vec3& size :
       {Vec3(1, 1, 1), Vec3(3, 0.1, 0.1), Vec3(0.05, 4, 0.05), Vec3(0.2, 0.1, 5), Vec3(2, 0.02, 2)})
    scenes.push_back(template_scene(slab(size), {.spread = false}));
  const Project project = Project::open(request.project);
  for (const ShapeId id : request.shapes) {
    const auto shape = load_figure_shape(project, id);
    REQUIRE(shape);
    add_shape(scenes.emplace_back(), *shape, true);
  }
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    CAPTURE(i);
    for (const auto& [width, height] :
         {std::pair(1000.0, 1000.0), std::pair(1000.0, 400.0), std::pair(400.0, 1000.0)}) {
      CAPTURE(width);
      CAPTURE(height);
      check_framed(request, scenes[i], width, height);
    }
  }
}

TEST_CASE("The window asks for the place of a figure, its width and whether it is transparent") {
  TestWindow window;
  show_fitted_chairs(window, 1);
  Studio& studio = window.studio();
  studio.settings.last_folder = window.scratch().path().string();
  REQUIRE(run_command(studio, "figure-templates"));
  window.settle();
  CHECK(studio.ui.browser.typed == "templates.png");
  const auto file = window.scratch().path() / "templates.png";
  studio.ui.browser.figure_width = 10;
  window.click("browser:open");
  CHECK(studio.ui.browser.open);  // no figure is that narrow
  studio.ui.browser.figure_width = 350;
  window.click("browser:transparent");
  CHECK(studio.ui.browser.transparent);
  window.click("browser:open");
  window.settle();
  CHECK_FALSE(studio.ui.browser.open);
  CHECK(png_width(file) == 350);
  studio.ui.browser = {};
  REQUIRE(run_command(studio, "figure-templates"));
  CHECK(studio.ui.browser.figure_width == 2400);
}

TEST_CASE("A figure may be transparent, and is the same in each run") {
  TestWindow window(300, 200);
  show_fitted_chairs(window, 2);
  const auto white = templates_figure(request_of(window, 240, false), {});
  const auto clear = templates_figure(request_of(window, 240, true), {});
  REQUIRE(white);
  REQUIRE(clear);
  CHECK(white->pixels[3] == 255);
  CHECK(clear->pixels[3] == 0);
  CHECK(*clear == *templates_figure(request_of(window, 240, true), {}));
  std::size_t drawn = 0;
  for (std::size_t i = 3; i < clear->pixels.size(); i += 4) drawn += clear->pixels[i] > 0;
  CHECK(drawn > clear->pixels.size() / 4 / 20);
}

TEST_CASE("The sheet of all members is as much higher as these need lines") {
  TestWindow window(300, 200);
  show_fitted_chairs(window, 18);
  const FigureRequest request = request_of(window, 240, false);
  const auto some = clusters_figure(request, {});
  const auto all = members_figure(request, {});
  REQUIRE(some);
  REQUIRE(all);
  const double line = (240 - 2 * 16 * 0.24) / 10;  // a tenth of the page without its margins
  CHECK(all->height - some->height == doctest::Approx(line).epsilon(0.05));
}

TEST_CASE("Templates before and after learning are drawn once they were measured") {
  TestWindow window(300, 200);
  show_fitted_chairs(window, 2);
  const FigureRequest request = request_of(window, 600, false);
  CHECK_THROWS_AS(starts_figure(request, {}), Error);
  CHECK_FALSE(run_command(window.studio(), "figure-starts", {}));
  Project project = Project::open(request.project);
  StartMeasure start;
  start.initial = project.templates().front().part_template;
  start.learned = {start.initial, start.initial};
  start.after.best_labelling = 0.9;
  store_start_measures(project, {start, start});
  const auto two = starts_figure(request, {});
  REQUIRE(two);
  CHECK(two->width == 600);
  start.learned.clear();
  store_start_measures(project, {start, start});
  const auto half = starts_figure(request, {});
  REQUIRE(half);
  CHECK_FALSE(*half == *two);
}

TEST_CASE("Sizes that no figure can have, and figures of nothing, are refused with the reason") {
  TestWindow window(300, 200);
  const auto file = (window.scratch().path() / "f.png").string();
  CHECK_FALSE(run_command(window.studio(), "figure-clusters", std::vector<std::string>{file}));
  window.open_chairs(1);
  for (const std::string width : {"0", "-5", "199", "1e9", "32001", "300.5", "nan", "wide"}) {
    CAPTURE(width);
    CHECK_FALSE(run_command(window.studio(), "figure-fit", std::vector<std::string>{file, width}));
  }
  // Nothing is fitted yet: the job says so.
  for (const char* name : {"figure-clusters", "figure-coalignment", "figure-fit", "figure-templates"}) {
    CAPTURE(name);
    REQUIRE(run_command(window.studio(), name, std::vector<std::string>{file, "200"}));
    window.settle();
    CHECK_FALSE(std::filesystem::exists(file));
    CHECK(window.studio().messages.list().back().severity == Severity::error);
  }
  FigureRequest request;
  request.shaders = window.studio().options.shaders;
  request.options.width = most_figure_side;
  FigurePage page(request);
  CHECK_THROWS_AS(page.set_height(1000), Error);  // 32,000 x 32,000
  request.options.width = 10;
  CHECK_THROWS_AS(FigurePage{request}, Error);
}

TEST_CASE("The report is saved by its command") {
  TestWindow window(300, 200);
  show_fitted_chairs(window, 2);
  const auto file = window.scratch().path() / "report.html";
  REQUIRE(run_command(window.studio(), "export-report", std::vector<std::string>{file.string()}));
  window.settle();
  const std::string page = read_file(file);
  CHECK(page.find("chair_00000") != std::string::npos);
  CHECK(page.find("data:image/png") != std::string::npos);
}
