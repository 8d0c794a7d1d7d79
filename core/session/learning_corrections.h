// What was corrected by hand, as learning from a collection heeds it.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/io/project.h"

namespace archetype {

class LearningCorrections {
 public:
  // Reads those of the project as they are now; pinned samples of shapes that were sampled anew since are
  // left out.
  explicit LearningCorrections(const Project& project);

  // Null where nothing was corrected. Stays where it is as long as this.
  const ShapeCorrection* of(ShapeId shape) const;
  // One per shape.
  std::vector<const ShapeCorrection*> of(const std::vector<ShapeId>& shapes) const;
  bool is_outlier(ShapeId shape) const;
  bool must_learn(ShapeId shape) const;
  // Whether some shape is pinned to the template of that name.
  bool is_pinned_to(const std::string& part_template) const;
  // In their order. Throws Error if all shapes are outliers, and there were some.
  std::vector<ShapeId> without_outliers(const std::vector<ShapeId>& shapes) const;

 private:
  std::map<ShapeId, ShapeCorrection> corrections_;
};

}  // namespace archetype
