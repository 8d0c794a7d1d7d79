// Generated shapes and templates from their ground truth, for tests of fitting and evaluation.
#pragma once

#include <string>
#include <vector>

#include "core/generate/generate.h"
#include "core/geometry/sample_shape.h"
#include "core/model/part_template.h"

namespace archetype::test {

struct MadeShape {
  GeneratedShape generated;
  ShapeSamples samples;
};

inline MadeShape make_shape(const std::string& family, const GenerateOptions& options, std::size_t index,
                            int points = 1000) {
  MadeShape shape;
  shape.generated = generate_shape(family, options, index);
  SamplingOptions sampling;
  sampling.points = points;
  sampling.up = shape.generated.up;
  shape.samples = sample_shape(shape.generated.mesh, {{index, 1}}, sampling);
  return shape;
}

// Adds the samples of the first `count` chairs of a style.
inline void add_chairs(std::vector<ShapeSamples>& shapes, const std::string& style, std::size_t count,
                       int points) {
  GenerateOptions options;
  options.styles = {style};
  for (std::size_t i = 0; i < count; ++i) shapes.push_back(make_shape("chairs", options, i, points).samples);
}

// One box per connected run of a label: faces of one label that share vertices.
PartTemplate template_from(const MadeShape& shape);

// Share of the area whose label is right, for labels of faces as label_elements() gives them.
double label_accuracy(const MadeShape& shape, const PartTemplate& part_template,
                      const std::vector<std::int16_t>& parts);

}  // namespace archetype::test
