// The probabilistic, part-based template of section 3 of the paper ("Template definition").
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "core/geometry/box.h"
#include "core/model/shape.h"

namespace archetype {

// A Gaussian per axis.
struct Gaussian3 {
  Vec3 mean = Vec3::Zero();
  Vec3 stddev = Vec3::Constant(0.2);
  friend bool operator==(const Gaussian3&, const Gaussian3&) = default;
};

struct FeatureGaussian {
  Features mean{};
  Features stddev{1, 1, 1, 1, 1, 1};
  friend bool operator==(const FeatureGaussian&, const FeatureGaussian&) = default;
};

// That a part is the mirror image of another one, and follows its edits. Both carry the same pair number.
struct MirrorLink {
  int pair = 0;  // above 0; 0: not linked
  int axis = 0;  // mirrored across x = 0 (0) or z = 0 (2)
  friend bool operator==(const MirrorLink&, const MirrorLink&) = default;
};

// One part: a box whose centre and half extents are Gaussian (normalised shape units; the box's own axes for
// the scale, the template's axes for the position) and whose surface has a Gaussian of local features.
struct TemplatePart {
  std::string name;
  int label = 0;  // what is written to label files; parts may share one
  bool must_exist = false;
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  Gaussian3 position;
  Gaussian3 scale{Vec3::Constant(0.2), Vec3::Constant(0.1)};  // half extents
  bool has_features = false;  // false: `features` is not known yet and is not written to files
  FeatureGaussian features;
  double existence = 1.0;  // share of the shapes that have this part, in (0, 1]
  MirrorLink mirror;
  int colour = -1;         // the number of a colour of part_colour(); -1: that of its place in the list
  std::string extra_json;  // keys of a file that this version does not know, kept and written back

  Box mean_box() const { return {position.mean, scale.mean, orientation}; }
  friend bool operator==(const TemplatePart& a, const TemplatePart& b) {
    return a.name == b.name && a.label == b.label && a.must_exist == b.must_exist &&
           a.orientation.coeffs() == b.orientation.coeffs() && a.position == b.position &&
           a.scale == b.scale && a.has_features == b.has_features && a.features == b.features &&
           a.existence == b.existence && a.mirror == b.mirror && a.colour == b.colour &&
           a.extra_json == b.extra_json;
  }
};

struct PartTemplate {
  std::string name;
  std::vector<TemplatePart> parts;
  std::string extra_json;  // as in TemplatePart
  friend bool operator==(const PartTemplate&, const PartTemplate&) = default;
};

}  // namespace archetype
