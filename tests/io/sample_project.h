// A small project with something in every table.
#pragma once

#include "core/io/project.h"

namespace archetype::test {

ShapeRecord sample_record(const std::string& name);
ShapeSamples sample_samples(std::size_t count = 5);  // numbers that a 32-bit float holds
PartTemplate sample_template();                      // two parts
ShapeFit sample_fit(std::size_t sample_count = 5);   // of two parts

ShapeCorrection sample_correction();  // of everything, for a shape "a"

// Adds a shape with fit, labels and thumbnail by `part_template`.
ShapeId add_whole_shape(Project& project, const std::string& name, TemplateId part_template);

// Two whole shapes, a template, a correction, a refused input and a setting.
void fill_project(Project& project);

// Reads everything that the project holds. Throws what the reading functions throw.
void read_whole_project(const Project& project);

}  // namespace archetype::test
