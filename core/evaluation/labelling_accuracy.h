// How well the labels of a collection agree with ground truth (section 5, "Segmentation accuracy", and Table
// 1).
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace archetype {

// A share of the elements (faces, or points of a point set), by area and by number.
struct ElementShare {
  double area = 0;
  double count = 0;

  ElementShare& operator+=(const ElementShare& other) {
    area += other.area;
    count += other.count;
    return *this;
  }
  friend bool operator==(const ElementShare&, const ElementShare&) = default;
};

// What of a shape lies in part `first` (an index into the parts of the collection; -1: in none) and has the
// ground-truth label `second`. All that the measures need of a shape.
using PartOverlap = std::map<std::pair<int, int>, ElementShare>;

// One entry per element in each; elements whose truth is negative have none and are left out. Areas are >= 0.
PartOverlap measure_overlap(std::span<const int> parts, std::span<const int> truth,
                            std::span<const double> areas);

// Fractions in [0, 1]; 1 for a shape without any area.
struct LabellingAccuracy {
  double by_area = 0;
  double by_count = 0;
};

struct ShapeAccuracy {
  std::string name;
  LabellingAccuracy own;   // with the labels that the templates give their parts
  LabellingAccuracy best;  // with the best assignment
};

struct LabellingReport {
  std::vector<ShapeAccuracy> shapes;  // as given
  ShapeAccuracy mean;                 // over the shapes: the main figure, as in Table 1
  ShapeAccuracy total;                // over the elements of all shapes
  // The label of ground truth that each part overlaps most by area over the whole collection (the smallest of
  // several; -1 for a part that overlaps none). Parts may share a label.
  std::vector<int> best_labels;
  // By (predicted label, true label), with the templates' own labels and with the best; -1: predicted as no
  // part.
  std::map<std::pair<int, int>, ElementShare> own_confusion;
  std::map<std::pair<int, int>, ElementShare> best_confusion;
  PartOverlap part_confusion;  // of all shapes together
};

struct ShapeOverlap {
  std::string name;
  PartOverlap overlap;
};

// `own_labels`: the label of every part of the collection. What lies in no part counts as wrong.
LabellingReport measure_labelling(std::span<const ShapeOverlap> shapes, std::span<const int> own_labels);

}  // namespace archetype
