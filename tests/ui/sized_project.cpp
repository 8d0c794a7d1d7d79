#include "tests/ui/sized_project.h"

#include <algorithm>
#include <cstdio>

#include "core/session/fit_collection.h"
#include "core/session/import_shapes.h"
#include "tests/support/small_collection.h"

namespace archetype::test {
namespace {

constexpr std::size_t most_read = 36;

// A seat on legs, without a back.
PartTemplate stool_template() {
  PartTemplate stool = chair_template();
  stool.name = "stool";
  stool.parts.erase(stool.parts.begin() + 1);
  return stool;
}

// What was read, once more: a little worse each time, so that no two are alike.
void add_copies(Project& project, std::size_t count) {
  const std::vector<ShapeRecord> originals = project.shapes();
  std::vector<ShapeSamples> samples;
  std::vector<FitRecord> fits;
  std::vector<std::vector<std::int16_t>> labels;
  for (const ShapeRecord& shape : originals) {
    samples.push_back(project.samples(shape.id));
    fits.push_back(project.fit(shape.id).value());
    labels.push_back(project.labels(shape.id).value());
  }
  for (std::size_t i = originals.size(); i < count; ++i) {
    const std::size_t of = i % originals.size();
    ShapeRecord shape = originals[of];
    char name[32];
    std::snprintf(name, sizeof name, "copy_%05zu", i);
    shape.name = name;
    FitRecord fit = fits[of];
    fit.shape = project.add_shape(shape, samples[of]);
    const double more = static_cast<double>(i) / static_cast<double>(count);
    fit.fit.energy.deformation += 0.1 * more;
    for (FittedPart& part : fit.fit.parts) part.box.centre.y() += 0.1 * more;
    project.store_fit(fit);
    project.store_labels(fit.shape, labels[of]);
  }
}

}  // namespace

std::filesystem::path make_sized_project(const std::filesystem::path& folder, std::size_t count) {
  const std::filesystem::path path = folder / ("sized" + std::to_string(count) + ".archetype");
  Project project = Project::create(path);
  if (count == 0) return path;
  write_chairs(folder / "read", std::min(count, most_read));
  import_shapes(project, {folder / "read" / "shapes"}, {.points = count > most_read ? 24 : 80}, {});
  fit_collection(project, {chair_template(), stool_template()}, {}, 0, {});
  Project::Transaction all(project);
  add_copies(project, count);
  const std::vector<ShapeId> shapes = project.shape_ids();
  for (std::size_t i = 5; i < shapes.size(); i += 10) project.set_fit_status(shapes[i], FitStatus::outlier);
  all.commit();
  return path;
}

}  // namespace archetype::test
