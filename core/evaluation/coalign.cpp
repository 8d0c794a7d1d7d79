// Takes the deformation of each part out of a shape.
#include "core/evaluation/coalign.h"

#include "core/base/error.h"

namespace archetype {

// With q a sample in the template's frame, B the fitted and M the mean box of its part, and m the closest
// point on B in box coordinates, the sample goes to M(m) + (q - B(m)). Differs from the paper: it prints the
// offset as d(m(p)) - p, which would mirror the surface at its box.
std::vector<Vec3> coalign(const PartTemplate& part_template, const ShapeSamples& samples,
                          const ShapeFit& fit) {
  if (fit.labels.size() != samples.size() || fit.parts.size() != part_template.parts.size()) {
    throw PreconditionError("coalign needs a fit of these samples by this template");
  }
  std::vector<Vec3> canonical;
  canonical.reserve(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Vec3 q = fit.to_template(samples.points[i]);
    const std::int16_t label = fit.labels[i];
    if (label < 0) {
      canonical.push_back(q);
      continue;
    }
    const auto part = static_cast<std::size_t>(label);
    const Box& fitted = fit.parts[part].box;
    const Vec3 match = closest_on_surface(fitted, q);
    canonical.push_back(part_template.parts[part].mean_box().to_world(match) + q - fitted.to_world(match));
  }
  return canonical;
}

}  // namespace archetype
