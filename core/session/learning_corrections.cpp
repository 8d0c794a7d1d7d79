#include "core/session/learning_corrections.h"

#include <algorithm>

#include "core/base/error.h"

namespace archetype {

LearningCorrections::LearningCorrections(const Project& project) {
  for (const auto& [shape, correction] : project.corrections()) {
    ShapeCorrection heeded = *correction;
    const auto record = project.find_shape(shape);
    if (!record || sampling_of(*record) != heeded.sampling) heeded.pinned.clear();
    if (!heeded.empty()) corrections_.emplace(shape, std::move(heeded));
  }
}

const ShapeCorrection* LearningCorrections::of(ShapeId shape) const {
  const auto found = corrections_.find(shape);
  return found == corrections_.end() ? nullptr : &found->second;
}

std::vector<const ShapeCorrection*> LearningCorrections::of(const std::vector<ShapeId>& shapes) const {
  std::vector<const ShapeCorrection*> result;
  result.reserve(shapes.size());
  for (const ShapeId shape : shapes) result.push_back(of(shape));
  return result;
}

bool LearningCorrections::is_outlier(ShapeId shape) const {
  const ShapeCorrection* correction = of(shape);
  return correction && correction->mark == ShapeMark::outlier;
}

bool LearningCorrections::must_learn(ShapeId shape) const {
  const ShapeCorrection* correction = of(shape);
  return correction && correction->mark == ShapeMark::learn;
}

bool LearningCorrections::is_pinned_to(const std::string& part_template) const {
  return std::ranges::any_of(corrections_, [&](const auto& each) {
    return each.second.part_template == part_template && each.second.mark != ShapeMark::outlier;
  });
}

std::vector<ShapeId> LearningCorrections::without_outliers(const std::vector<ShapeId>& shapes) const {
  std::vector<ShapeId> result;
  for (const ShapeId shape : shapes)
    if (!is_outlier(shape)) result.push_back(shape);
  if (result.empty() && !shapes.empty())
    throw Error("every shape is marked as an outlier: there is none to learn from");
  return result;
}

}  // namespace archetype
