#include "tests/io/sample_project.h"

namespace archetype::test {

ShapeRecord sample_record(const std::string& name) {
  ShapeRecord record;
  record.name = name;
  record.path = "/shapes/" + name + ".off";
  record.hash.words = {name.size(), 77};
  record.up = UpAxis::minus_z;
  record.vertex_count = 8;
  record.element_count = 6;
  record.requested_points = 500;
  record.seed = 0xfedcba9876543210;
  return record;
}

ShapeSamples sample_samples(std::size_t count) {
  ShapeSamples samples;
  samples.frame = {upright_rotation(UpAxis::minus_z), {0.1, 1e7, -3}, 0.3};
  samples.radius = 2.5;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = static_cast<double>(i) / 8;
    samples.points.emplace_back(x, 1 - x, -2);
    samples.normals.emplace_back(0, 1, 0);
    samples.faces.push_back(static_cast<std::uint32_t>(i % 6));
    samples.features_x.push_back({x, 0.25, 0.5, 1, 0, 0});
    samples.features_z.push_back({0.25, x, 0.5, 1, 0, 0});
  }
  return samples;
}

PartTemplate sample_template() {
  PartTemplate part_template;
  part_template.name = "stool";
  part_template.parts.resize(2);
  part_template.parts[0].name = "seat";
  part_template.parts[1].name = "leg";
  part_template.parts[1].label = 7;
  part_template.parts[1].position.mean = {0.1, -0.7, 0.3};
  return part_template;
}

ShapeFit sample_fit(std::size_t sample_count) {
  ShapeFit fit;
  fit.yaw_quarters = 3;
  fit.translation = {0.1, 0.2, -0.3};
  fit.parts.resize(2);
  fit.parts[0] = {true,
                  {{0, 0.1, 0}, {1, 0.1, 1}, Eigen::Quaterniond(0.5, 0.5, -0.5, 0.5), Solid::cylinder_y}};
  for (std::size_t i = 0; i < sample_count; ++i) fit.labels.push_back(static_cast<std::int16_t>(i % 3) - 1);
  fit.energy = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6};
  fit.alternations = 12;
  fit.converged = true;
  fit.yaw_energies = {2, std::numeric_limits<double>::infinity(), 3, 2.1};
  return fit;
}

ShapeCorrection sample_correction() {
  ShapeCorrection correction;
  correction.yaw_quarters = 3;
  correction.part_template = "stool";
  correction.mark = ShapeMark::learn;
  correction.pinned = {{"seat", {0, 2}}, {"", {4}}};
  correction.sampling = sampling_of(sample_record("a"));
  return correction;
}

ShapeId add_whole_shape(Project& project, const std::string& name, TemplateId part_template) {
  const ShapeId id = project.add_shape(sample_record(name), sample_samples());
  project.store_fit({id, part_template, FitStatus::outlier, sample_fit(), {{5, 6}}});
  project.store_labels(id, {0, 1, -1, 0, 1, 1});
  project.store_thumbnail(id, "surface", {2, 1, {1, 2, 3, 4, 5, 6, 7, 8}});
  return id;
}

void fill_project(Project& project) {
  Project::Transaction transaction(project);
  TemplateRecord record;
  record.part_template = sample_template();
  const TemplateId part_template = project.add_template(record);
  add_whole_shape(project, "b", part_template);
  const ShapeId a = add_whole_shape(project, "a", part_template);
  project.set_corrections({{a, std::make_shared<const ShapeCorrection>(sample_correction())}});
  project.set_refused({{"/shapes/bad.off", "line 1: expected OFF"}});
  project.set_setting("key", "value");
  transaction.commit();
}

void read_whole_project(const Project& project) {
  for (const ShapeRecord& shape : project.shapes()) {
    static_cast<void>(project.find_shape(shape.id));
    static_cast<void>(project.find_shape(shape.name));
    static_cast<void>(project.samples(shape.id));
    static_cast<void>(project.fit(shape.id));
    static_cast<void>(project.labels(shape.id));
    static_cast<void>(project.thumbnail(shape.id, "surface"));
  }
  static_cast<void>(project.templates(false));
  static_cast<void>(project.templates());
  static_cast<void>(project.fits());
  static_cast<void>(project.refused());
  static_cast<void>(project.corrections());
  static_cast<void>(project.setting("key"));
}

}  // namespace archetype::test
