#include "core/fitting/expected_template.h"

#include "core/fitting/template_surface.h"

namespace archetype {

namespace {

// Differs from the paper: a fit expects nothing more closely than this (normalised units). Spreads that were
// learned from many shapes tell templates apart (template_choice.h), but would hold a shape that is a little
// different so tightly that its labels follow the boxes instead of the surface.
constexpr double least_position_stddev = 0.05;
constexpr double least_scale_stddev = 0.025;

}  // namespace

PartTemplate expected_template(const PartTemplate& part_template) {
  PartTemplate expected = with_expected_features(part_template);
  for (TemplatePart& part : expected.parts) {
    part.position.stddev = part.position.stddev.cwiseMax(least_position_stddev);
    part.scale.stddev = part.scale.stddev.cwiseMax(least_scale_stddev);
  }
  return expected;
}

}  // namespace archetype
