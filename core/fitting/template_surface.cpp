// Even samples of boxes.
#include "core/fitting/template_surface.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/features.h"

namespace archetype {

namespace {

// Points of one box at about the given spacing.
void sample_box(const Vec3& half, double spacing, std::vector<Vec3>& out) {
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    const int nu = std::clamp(static_cast<int>(std::lround(2 * half[u] / spacing)), 2, 100);
    const int nv = std::clamp(static_cast<int>(std::lround(2 * half[v] / spacing)), 2, 100);
    for (const double side : {-1.0, 1.0}) {
      for (int i = 0; i < nu; ++i) {
        for (int j = 0; j < nv; ++j) {
          Vec3 p;
          p[axis] = side;
          p[u] = (2 * i + 1.0) / nu - 1;
          p[v] = (2 * j + 1.0) / nv - 1;
          out.push_back(p);
        }
      }
    }
  }
}

}  // namespace

double surface_area(const Vec3& half) {
  return 8.0 * (half[0] * half[1] + half[1] * half[2] + half[2] * half[0]);
}

TemplateSurface sample_template(const PartTemplate& part_template, int count) {
  double area = 0;
  for (const TemplatePart& part : part_template.parts) area += surface_area(part.scale.mean);
  const double spacing = std::sqrt(area / count);
  TemplateSurface surface;
  surface.begins.push_back(0);
  for (const TemplatePart& part : part_template.parts) {
    sample_box(part.scale.mean, spacing, surface.local);
    surface.begins.push_back(static_cast<std::uint32_t>(surface.local.size()));
  }
  return surface;
}

PartTemplate with_expected_features(const PartTemplate& part_template) {
  PartTemplate result = part_template;
  if (std::all_of(result.parts.begin(), result.parts.end(), [](const auto& p) { return p.has_features; }))
    return result;
  const TemplateSurface surface = sample_template(part_template, 2000);
  std::vector<Vec3> points;
  for (std::size_t k = 0; k < result.parts.size(); ++k) {
    const Box box = result.parts[k].mean_box();
    for (auto i = surface.begins[k]; i < surface.begins[k + 1]; ++i)
      points.push_back(box.to_world(surface.local[i]));
  }
  Bounds extent;
  for (const Vec3& p : points) extent.add(p);
  // The boxes stand for a whole shape, whose R is close to the diagonal of its bounds.
  const PointFeatures features = compute_features(points, feature_radius * 2 * extent.half_extent().norm());
  for (std::size_t k = 0; k < result.parts.size(); ++k) {
    TemplatePart& part = result.parts[k];
    if (part.has_features) continue;
    const double n = surface.begins[k + 1] - surface.begins[k];
    Features mean{};
    Features square{};
    for (auto i = surface.begins[k]; i < surface.begins[k + 1]; ++i) {
      for (std::size_t f = 0; f < mean.size(); ++f) {
        mean[f] += features.x[i][f] / n;
        square[f] += features.x[i][f] * features.x[i][f] / n;
      }
    }
    // Real parts are not boxes: no feature is expected more closely than this.
    constexpr double smallest_stddev = 0.2;
    for (std::size_t f = 0; f < mean.size(); ++f) {
      part.features.mean[f] = mean[f];
      part.features.stddev[f] =
          std::max(std::sqrt(std::max(square[f] - mean[f] * mean[f], 0.0)), smallest_stddev);
    }
    part.has_features = true;
  }
  return result;
}

}  // namespace archetype
