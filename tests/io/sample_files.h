// A small valid file of every kind that is read.
#pragma once

#include <string>
#include <vector>

namespace archetype::test {

struct SampleFile {
  std::string name;
  std::string bytes;
};

// Shapes in all formats and encodings. Each has fractions in its coordinates.
std::vector<SampleFile> sample_shapes();
// A template, labels of three faces in both forms (*.seg, *_labels.txt), landmarks (*.vts).
std::vector<SampleFile> sample_side_files();

}  // namespace archetype::test
