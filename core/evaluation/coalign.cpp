// Takes the deformation of each part out of a shape.
#include "core/evaluation/coalign.h"

#include "core/base/error.h"
#include "core/fitting/settle_boxes.h"

namespace archetype {

namespace {

// What the deformation weighs against the distances, and the spread that every part is given instead of the
// learned one: enough that a part of a few samples keeps the extents that they do not tell. Ten times less
// changes nothing any more.
constexpr double free_alpha = 5e-5;
constexpr double free_stddev = 0.2;  // normalised units

// Of matching and deforming. Each halves what is left to gain, or better.
constexpr int free_steps = 10;

void require_match(const PartTemplate& part_template, const ShapeSamples& samples, const ShapeFit& fit) {
  if (fit.labels.size() != samples.size() || fit.parts.size() != part_template.parts.size())
    throw PreconditionError("coalign needs a fit of these samples by this template");
}

}  // namespace

std::vector<Box> free_boxes(const PartTemplate& given, const ShapeSamples& samples, const ShapeFit& fit) {
  require_match(given, samples, fit);
  PartTemplate part_template = given;
  for (TemplatePart& part : part_template.parts)
    part.position.stddev = part.scale.stddev = Vec3::Constant(free_stddev);
  FitOptions options;
  options.alpha = free_alpha;
  return settle_boxes(part_template, samples, fit, options, free_steps);
}

Sharpness& Sharpness::operator+=(const Sharpness& other) {
  rigid += other.rigid;
  deformed += other.deformed;
  between += other.between;
  samples += other.samples;
  return *this;
}

// With r and d what is left of a sample at either end, (1 - b) r + b d is left between them.
double Sharpness::mean_at(double blend) const {
  if (samples == 0) return 0;
  const double rest = 1 - blend;
  return (rest * rest * rigid + 2 * rest * blend * between + blend * blend * deformed) /
         static_cast<double>(samples);
}

// With q a sample in the template's frame, B the fitted and M the mean box of its part, and m the closest
// point on B in box coordinates, the sample goes to M(m) + (q - B(m)). Differs from the paper: it prints the
// offset as d(m(p)) - p, which would mirror the surface at its box.
Coaligned coalign(const PartTemplate& part_template, const ShapeSamples& samples, const ShapeFit& fit,
                  std::span<const Box> boxes) {
  require_match(part_template, samples, fit);
  if (boxes.size() != part_template.parts.size())
    throw PreconditionError("coalign needs a box for every part");
  Coaligned result;
  result.rigid.reserve(samples.size());
  result.deformed.reserve(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Vec3 q = fit.to_template(samples.points[i]);
    result.rigid.push_back(q);
    const std::int16_t label = fit.labels[i];
    if (label < 0) {
      result.deformed.push_back(q);
      continue;
    }
    const auto part = static_cast<std::size_t>(label);
    const Vec3 match = closest_on_surface(boxes[part], q);
    const Vec3 offset = q - boxes[part].to_world(match);
    const Vec3 canonical = part_template.parts[part].mean_box().to_world(match);
    result.deformed.emplace_back(canonical + offset);
    const Vec3 left = q - canonical;
    result.sharpness += {left.squaredNorm(), offset.squaredNorm(), left.dot(offset), 1};
  }
  return result;
}

std::vector<Vec3> coalign(const PartTemplate& part_template, const ShapeSamples& samples,
                          const ShapeFit& fit) {
  return coalign(part_template, samples, fit, free_boxes(part_template, samples, fit)).deformed;
}

}  // namespace archetype
