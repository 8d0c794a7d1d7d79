// What plots are made of, made up: numbers that can be checked by hand, and names that nobody would choose.
#pragma once

#include "core/report/plot_catalog.h"

namespace archetype::test {

// Markup, quotes, line ends, what is no UTF-8 and what XML forbids.
inline const std::string hostile_name = "</text><script>\"'&,;\r\n\t\x01\x7f\xff\xc3 ÅΩ \xed\xa0\x80 name";

// Two templates; the first has two parts: the second of them is there on every other shape. Shape i has its
// seat at height i / count, and every third takes the second template.
inline FitTable made_fits(std::size_t count, const std::string& name = "chair") {
  FitTable table;
  for (int t = 0; t < 2; ++t) {
    TemplateRecord record;
    record.id = t + 1;
    record.part_template.name = t == 0 ? name : name + " 2";
    for (int p = 0; p < 2 - t; ++p) {
      TemplatePart part;
      part.name = p == 0 ? name + " seat" : name + " back";
      part.label = p;
      part.position = {{0, 0.5 + p, 0}, {0.25, 0.25, 0.25}};
      part.scale = {{0.5, 0.1, 0.5}, {0.1, 0.05, 0.1}};
      part.existence = p == 0 ? 1 : 0.5;
      record.part_template.parts.push_back(part);
    }
    table.templates.push_back(record);
  }
  for (std::size_t i = 0; i < count; ++i) {
    FitTableRow row;
    row.summary.shape = static_cast<ShapeId>(i + 1);
    row.part_template = i % 3 == 2 ? 1 : 0;
    row.summary.part_template = table.templates[row.part_template].id;
    row.summary.energy.features = 0.1 + 0.01 * static_cast<double>(i % 10);
    row.summary.energy.deformation = 0.05;
    row.summary.status = i % 5 == 4 ? FitStatus::outlier : FitStatus::fitted;
    row.first_part = table.parts.size();
    const double height = static_cast<double>(i) / static_cast<double>(count);
    table.rows.push_back(row);
    table.parts.push_back({true, {{0.1, height, 0}, {0.5, 0.1, 0.4}}, 0.6});
    if (row.part_template == 0) table.parts.push_back({i % 2 == 0, {{0, 1.5, 0}, {0.5, 0.1, 0.5}}, 0.4});
  }
  return table;
}

inline LearningRecord made_record(const std::string& name = "chair") {
  LearningRecord record;
  record.start.push_back({.name = name, .parts = {}, .extra_json = {}});
  record.judging = {1, 2, 3};
  record.steps.push_back({1, 0.9, 0.6, {1}, {0}, {0, 0, 0}});
  record.steps.push_back({2, 0.6, 0.5, {1, 2}, {0, 1}, {0, 1, 0}});
  return record;
}

// Label 0 is found on 3 of 4 parts of its area, label 1 on all; the second part takes the rest.
inline LabellingEvaluation made_labelling(const std::string& name = "chair") {
  LabellingEvaluation evaluation;
  evaluation.parts = {{name, name + " seat", 0}, {name, name + " back", 1}};
  evaluation.label_names = {name, "back"};
  ShapeOverlap shape{name, {}};
  shape.overlap[{0, 0}] = {3, 3};
  shape.overlap[{1, 0}] = {1, 1};
  shape.overlap[{1, 1}] = {4, 4};
  const std::vector<ShapeOverlap> shapes{shape};
  const std::vector<int> labels{0, 1};
  evaluation.report = measure_labelling(shapes, labels);
  return evaluation;
}

inline LandmarkEvaluation made_landmarks(const std::string& name = "chair") {
  LandmarkEvaluation evaluation;
  evaluation.landmarks.resize(2);
  for (int i = 0; i < 4; ++i) {
    CorrespondenceCurves curves;
    curves.by_diameter.add(0.02 * i);
    curves.by_diagonal.add(0.01 * i);
    evaluation.all += curves;
    evaluation.landmarks[static_cast<std::size_t>(i % 2)] += curves;
  }
  evaluation.landmark_names = {name + " tip", "foot"};
  evaluation.shapes.resize(2);
  return evaluation;
}

}  // namespace archetype::test
