// Where the energy of a fit comes from: sample by sample, and part by part.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/fitting/fit_options.h"
#include "core/model/part_template.h"
#include "core/model/shape.h"
#include "core/model/shape_fit.h"

namespace archetype {

// The terms in the order in which they are shown.
inline constexpr std::array energy_terms{&FitEnergy::shape_to_template, &FitEnergy::template_to_shape,
                                         &FitEnergy::features,          &FitEnergy::deformation,
                                         &FitEnergy::smoothness,        &FitEnergy::existence};

struct FitInspection {
  // The share of each part in each term, and in the last entry that of samples without a part. Together they
  // are the energy of the fit.
  std::vector<FitEnergy> parts;

  // One per sample, before they are averaged: their means are the terms of the same names.
  std::vector<double> shape_to_template;
  std::vector<double> features;
  std::vector<double> smoothness;
  std::vector<Vec3> on_template;  // its correspondence on the fitted box, template's frame; itself where null

  // Samples of the fitted boxes of the parts that are there.
  struct TemplatePoint {
    Vec3 position = Vec3::Zero();  // template's frame
    std::int16_t part = 0;
    std::uint32_t sample = 0;  // its correspondence on the shape
    double distance = 0;       // squared, as it enters the mean of equation 4
  };
  std::vector<TemplatePoint> template_points;
};

// `fit` is one of `samples` by `part_template`, with these options. Some milliseconds for 1,000 samples.
// Throws PreconditionError where they do not belong together.
FitInspection inspect_fit(const PartTemplate& part_template, const ShapeSamples& samples, const ShapeFit& fit,
                          const FitOptions& options);

}  // namespace archetype
