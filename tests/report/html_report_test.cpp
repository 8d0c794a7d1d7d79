// The page about a project: what it holds, and that nothing in a project can get out of its place on it.
#include "core/report/html_report.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>

#include "core/report/html_text.h"
#include "core/report/report_pictures.h"
#include "core/report/template_svg.h"
#include "core/session/fit_collection.h"
#include "core/session/import_shapes.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/small_collection.h"

using namespace archetype;
using namespace archetype::test;

namespace {

std::size_t count_of(const std::string& text, const std::string& piece) {
  std::size_t count = 0;
  for (std::size_t at = text.find(piece); at != std::string::npos; at = text.find(piece, at + 1)) ++count;
  return count;
}

// Every element that is opened is closed, in order; what needs no end is left out.
bool is_balanced(const std::string& page) {
  std::vector<std::string> open;
  for (std::size_t at = page.find('<'); at != std::string::npos; at = page.find('<', at + 1)) {
    const std::size_t end = page.find_first_of(" >/\n", at + 2);
    const std::size_t close = page.find('>', at);
    if (end == std::string::npos || close == std::string::npos) return false;
    const bool ends = page[at + 1] == '/';
    const std::string name = page.substr(at + (ends ? 2 : 1), end - at - (ends ? 2 : 1));
    const bool alone =
        name == "!DOCTYPE" || name == "meta" || name == "img" || name == "br" || page[close - 1] == '/';
    if (alone) continue;
    if (!ends) {
      open.push_back(name);
      continue;
    }
    if (open.empty() || open.back() != name) return false;
    open.pop_back();
  }
  return open.empty();
}

ShapeRecord record_named(const std::string& name) {
  ShapeRecord record;
  record.name = name;
  record.path = "/nowhere/shape.obj";
  record.element_count = 1;
  record.radius = 1;
  record.requested_points = 2;
  return record;
}

ShapeSamples two_samples() {
  ShapeSamples samples;
  samples.radius = 1;
  samples.points = {{0, 0, 0}, {1, 0, 0}};
  samples.normals = {{0, 0, 1}, {0, 1, 0}};
  samples.faces = {0, 0};
  samples.features_x.resize(2);
  samples.features_z.resize(2);
  return samples;
}

}  // namespace

TEST_CASE("the report shows shapes, templates, clusters, worst fits, accuracy and settings") {
  const ScratchFolder folder;
  write_chairs(folder.path(), 5);
  Project project = Project::create(folder.path() / "Chairs of May.archetype");
  ImportOptions import;
  import.points = 150;
  import_shapes(project, {folder.path() / "shapes"}, import, {});
  fit_collection(project, {chair_template()}, {}, 2, {});
  project.set_fit_status(project.shape_ids()[1], FitStatus::outlier);
  ReportOptions options;
  options.labels = folder.path() / "labels";
  const auto report = html_report(project, options, {});
  REQUIRE(report);
  CHECK(report->shapes == 5);
  CHECK(report->pictures == 10);  // in its cluster or as an outlier, and among the worst
  const std::string& page = report->page;
  CHECK(is_balanced(page));
  for (const char* section : {"collection", "templates", "clusters", "worst", "accuracy", "settings"}) {
    CAPTURE(section);
    CHECK(page.find("id=\"" + std::string(section) + '"') != std::string::npos);
    CHECK(page.find("href=\"#" + std::string(section) + '"') != std::string::npos);
  }
  CHECK(page.find("<h1>Chairs of May</h1>") != std::string::npos);
  CHECK(page.find("Outliers (1)") != std::string::npos);
  CHECK(count_of(page, "data:image/png;base64,") == 10);
  CHECK(count_of(page, "<svg class=\"plot\"") == 2);  // accuracy by label, and confusion
  CHECK(page.find("mean over 5 shapes") != std::string::npos);
  CHECK(page.find(ARCHETYPE_VERSION) != std::string::npos);
  // Nothing is loaded from anywhere.
  CHECK(page.find("<script") == std::string::npos);
  CHECK(page.find("src=\"http") == std::string::npos);
  CHECK(page.find("url(") == std::string::npos);
  CHECK(html_report(project, options, {})->page == page);
  std::stop_source stop;
  stop.request_stop();
  JobControl control;
  control.stop = stop.get_token();
  CHECK_FALSE(html_report(project, options, control));
}

TEST_CASE("an empty project has a report, too") {
  const auto report = html_report(Project::in_memory(), {}, {});
  REQUIRE(report);
  CHECK(is_balanced(report->page));
  CHECK(report->pictures == 0);
  CHECK(report->page.find("There is no template yet.") != std::string::npos);
}

TEST_CASE("names of strangers stay text") {
  const std::string evil = "</td><script>alert(1)</script>\"'&<img src=x onerror=y>";
  Project project = Project::in_memory();
  project.add_shape(record_named(evil), two_samples());
  project.add_shape(record_named("broken \xff\xc0 \x01 bytes"), two_samples());
  TemplateRecord record;
  record.part_template.name = evil;
  record.part_template.parts.resize(1);
  record.part_template.parts[0].name = evil;
  const TemplateId id = project.add_template(record);
  for (const ShapeId shape : project.shape_ids()) {
    FitRecord fit;
    fit.shape = shape;
    fit.part_template = id;
    fit.fit.parts.push_back({true, record.part_template.parts[0].mean_box()});
    fit.fit.labels = {0, -1};
    project.store_fit(fit);
  }
  project.set_refused({{"/tmp/" + evil, evil}});
  ReportOptions options;
  options.title = evil;
  const auto report = html_report(project, options, {});
  REQUIRE(report);
  CHECK(is_balanced(report->page));
  CHECK(report->page.find("<script") == std::string::npos);
  CHECK(report->page.find("<img src=x") == std::string::npos);
  CHECK(report->page.find("&lt;script&gt;") != std::string::npos);
  CHECK(report->page.find('\xff') == std::string::npos);
  CHECK(report->page.find('\x01') == std::string::npos);
}

TEST_CASE("the report of ten thousand shapes stays small") {
  Project project = Project::in_memory();
  Project::Transaction transaction(project);
  TemplateRecord record;
  record.part_template = chair_template();
  const TemplateId id = project.add_template(record);
  for (int i = 0; i < 10'000; ++i) {
    FitRecord fit;
    fit.shape = project.add_shape(record_named("shape_" + std::to_string(i)), two_samples());
    fit.part_template = id;
    for (const TemplatePart& part : record.part_template.parts)
      fit.fit.parts.push_back({true, part.mean_box()});
    fit.fit.labels = {0, 1};
    fit.fit.energy.features = i;
    project.store_fit(fit);
  }
  transaction.commit();
  const auto report = html_report(project, {}, {});
  REQUIRE(report);
  CHECK(report->page.size() < 2'000'000);
  CHECK(report->page.find("and 9976 others") != std::string::npos);
  CHECK(report->page.find("shape_9999") != std::string::npos);  // the worst
}

TEST_CASE("pictures inside of a page read back as what was written") {
  // 1, 2 and 3 bytes are padded as RFC 4648 says: a PNG's length decides, so try several sizes.
  for (int side = 1; side < 6; ++side) {
    Picture picture{side, side, std::vector<std::uint8_t>(static_cast<std::size_t>(4 * side * side), 200)};
    const std::string html = html_picture(picture, "a \"b\"");
    CHECK(html.starts_with("<img alt=\"a &quot;b&quot;\" src=\"data:image/png;base64,iVBORw0KGgo"));
    const std::size_t begin = html.find("base64,") + 7;
    const std::size_t length = html.find('"', begin) - begin;
    CHECK(length % 4 == 0);
  }
}

TEST_CASE("samples are drawn in the colours of their parts without OpenGL") {
  const ShapeSamples samples = two_samples();
  PartTemplate part_template = chair_template();
  ShapeFit fit;
  fit.labels = {0, null_label};
  fit.parts.resize(part_template.parts.size());
  const Picture plain = sample_picture(samples, nullptr, nullptr, 64);
  const Picture parts = sample_picture(samples, &part_template, &fit, 64);
  CHECK(plain.width == 64);
  CHECK(plain.pixels.size() == 4 * 64 * 64);
  CHECK_FALSE(plain == parts);
  CHECK(std::ranges::count(plain.pixels, 255) > 20);
  CHECK(sample_picture({}, nullptr, nullptr, 8).pixels == std::vector<std::uint8_t>(256, 0));
}

TEST_CASE("a part that most shapes lack is a dashed outline in the picture of the template") {
  PartTemplate part_template = chair_template();
  const auto count = [&](const std::string& text) {
    const std::string svg = template_svg(part_template, 100);
    std::size_t found = 0;
    for (std::size_t at = svg.find(text); at != std::string::npos; at = svg.find(text, at + 1)) ++found;
    return found;
  };
  REQUIRE(count("fill=\"none\"") == 0);
  const std::size_t spreads = count("<ellipse");
  TemplatePart& back = part_template.parts[1];
  back.must_exist = false;
  back.existence = 0.2;
  CHECK(count("fill=\"none\"") == 3);  // of its faces that look at the viewer
  CHECK(count("<ellipse") == spreads - 1);
  back.must_exist = true;
  CHECK(count("fill=\"none\"") == 0);
}

TEST_CASE("a template with numbers from outside is still a picture") {
  PartTemplate part_template;
  part_template.parts.resize(2);
  part_template.parts[0].position.mean = Vec3::Constant(1e300);
  part_template.parts[1].scale.mean = Vec3::Constant(1e-300);
  for (const PartTemplate& each : {PartTemplate{}, part_template, chair_template()}) {
    const std::string svg = template_svg(each, 100);
    CHECK(svg.find("nan") == std::string::npos);
    CHECK(svg.find("inf") == std::string::npos);
    CHECK(svg.size() < 40'000);
  }
}
