#include "tests/ui/made_project.h"

#include <doctest/doctest.h>

#include <cstdio>

#include "core/session/fit_table.h"
#include "tests/report/made_reports.h"
#include "ui/project_actions.h"

namespace archetype::test {
namespace {

ShapeRecord made_shape(std::size_t i) {
  ShapeRecord shape;
  char name[32];
  std::snprintf(name, sizeof name, "shape_%05zu", i);
  shape.name = name;
  shape.path = "/none/" + shape.name + ".off";
  shape.element_count = 12;
  shape.radius = 1;
  return shape;
}

// A few points are enough for a picture.
ShapeSamples made_samples(std::size_t i) {
  ShapeSamples samples;
  samples.radius = 2;
  for (int p = 0; p < 8; ++p) {
    samples.points.emplace_back(p & 1 ? 1 : -1, p & 2 ? 1.0 + 0.001 * static_cast<double>(i % 500) : -1.0,
                                p & 4 ? 1 : -1);
    samples.normals.emplace_back(Vec3::UnitY());
    samples.faces.push_back(static_cast<std::uint32_t>(p));
  }
  samples.features_x.resize(8);
  samples.features_z.resize(8);
  return samples;
}

}  // namespace

void open_made(TestWindow& window, std::size_t count) {
  const std::filesystem::path path =
      window.scratch().path() / ("made" + std::to_string(count) + ".archetype");
  const FitTable made = made_fits(count);
  {
    Project project = Project::create(path);
    Project::Transaction all(project);
    std::vector<TemplateId> templates;
    for (const TemplateRecord& record : made.templates) templates.push_back(project.add_template(record));
    project.set_current_templates(templates);
    for (std::size_t i = 0; i < count; ++i) {
      const ShapeId shape = project.add_shape(made_shape(i), made_samples(i));
      const FitTableRow& row = made.rows[i];
      FitRecord fit;
      fit.shape = shape;
      fit.part_template = templates[row.part_template];
      fit.status = row.summary.status;
      fit.fit.energy = row.summary.energy;
      for (const PartValues& part : made.parts_of(row)) fit.fit.parts.push_back({part.present, part.box});
      fit.fit.labels.assign(8, 0);
      project.store_fit(fit);
    }
    all.commit();
  }
  open_project(window.studio(), path);
  window.settle();
  REQUIRE(window.studio().collection.rows().size() == count);
}

}  // namespace archetype::test
