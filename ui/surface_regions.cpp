#include "ui/surface_regions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "core/geometry/box_points.h"
#include "core/geometry/face_adjacency.h"
#include "core/learning/region_box.h"
#include "core/learning/segment_shape.h"

namespace archetype {
namespace {

constexpr std::size_t enough_samples = 24;  // for the axes of a region to mean something
constexpr double alike_extents = 1.25;
constexpr double nearly_as_small = 1.15;  // times the volume
constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

// Where two extents are about the same, as of a square leg or back, the points do not say how the box turns
// in their plane: it does not.
Eigen::Quaterniond without_twist(const Box& box) {
  for (int axis = 0; axis < 3; ++axis) {
    const double a = box.half_extent[(axis + 1) % 3];
    const double b = box.half_extent[(axis + 2) % 3];
    if (std::max(a, b) < alike_extents * std::min(a, b))
      return Eigen::Quaterniond::FromTwoVectors(Vec3::Unit(axis), box.orientation * Vec3::Unit(axis));
  }
  return box.orientation;
}

// A back that leans is turned about one axis of the shape. The axes of its points are turned a little about
// the others, too, where it is no rectangle: the simpler turn is taken where its box is nearly as small.
Eigen::Quaterniond about_one_axis(const Eigen::Quaterniond& own, std::span<const Vec3> points,
                                  double spacing) {
  // A flat region has a volume, too, but what is as thin as a leg is not made thicker by what counts as none.
  const auto volume = [&](const Eigen::Quaterniond& orientation) {
    return (box_around(points, orientation).half_extent.array() + 0.05 * spacing).prod();
  };
  Eigen::Quaterniond best = own;
  double least = nearly_as_small * volume(own);
  for (int axis = 0; axis < 3; ++axis) {
    const double along = own.vec()[axis];
    const double length = std::hypot(own.w(), along);
    if (length < 1e-6) continue;
    Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
    turn.w() = own.w() / length;
    turn.vec()[axis] = along / length;
    if (const double v = volume(turn); v < least) least = v, best = turn;
  }
  return best;
}

// The axes that the samples of a region suggest; those of the shape where they are few.
Eigen::Quaterniond axes_of(const std::vector<Vec3>& points, const ShapeSamples& samples) {
  if (points.size() < enough_samples) return Eigen::Quaterniond::Identity();
  const double spacing = spacing_of(samples);
  return about_one_axis(
      without_twist(fit_region_box(points, 0.1 * samples.radius, spacing, RegionSolids::boxes).box), points,
      spacing);
}

SurfaceRegions of_segments(Segmentation segments, const ShapeSamples& samples) {
  std::vector<std::vector<Vec3>> points(segments.boxes.size());
  for (std::size_t i = 0; i < samples.size(); ++i)
    if (segments.labels[i] >= 0)
      points[static_cast<std::size_t>(segments.labels[i])].push_back(samples.points[i]);
  for (std::size_t s = 0; s < points.size(); ++s) {
    if (points[s].empty()) continue;
    const Eigen::Quaterniond own = segments.boxes[s].orientation;
    const Eigen::Quaterniond turned = about_one_axis(own, points[s], spacing_of(samples));
    if (turned.angularDistance(own) > 1e-9) segments.boxes[s] = box_around(points[s], turned);
  }
  SurfaceRegions found;
  found.of_sample = std::move(segments.labels);
  found.boxes = std::move(segments.boxes);
  return found;
}

SurfaceRegions components(const RegionRequest& request, const JobControl& control) {
  SurfaceRegions found;
  const ShapeSamples& samples = *request.samples;
  const bool faces = request.mesh && !request.mesh->is_point_set();
  const std::vector<std::uint32_t> of_face =
      faces ? face_components(*request.mesh) : std::vector<std::uint32_t>{};
  std::vector<std::uint32_t> region_of;  // component to region
  std::vector<std::vector<Vec3>> points;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const std::uint32_t component = faces ? of_face[samples.faces[i]] : 0;
    if (component >= region_of.size()) region_of.resize(component + 1, none);
    if (region_of[component] == none) {
      region_of[component] = static_cast<std::uint32_t>(points.size());
      points.emplace_back();
    }
    points[region_of[component]].push_back(samples.points[i]);
    found.of_sample.push_back(static_cast<std::int16_t>(region_of[component]));
  }
  for (const std::vector<Vec3>& region : points) {
    if (control.stop.stop_requested()) return found;
    found.boxes.push_back(box_around(region, axes_of(region, samples)));
  }
  // The samples stay inside of the surface; its corners are its extent.
  for (std::size_t f = 0; f < of_face.size(); ++f) {
    const std::uint32_t region = of_face[f] < region_of.size() ? region_of[of_face[f]] : none;
    if (region == none) continue;
    for (const std::uint32_t corner : request.mesh->face(f)) {
      const Vec3 place[] = {samples.frame.to_normalised(request.mesh->vertices[corner])};
      if (found.boxes[region].to_local(place[0]).cwiseAbs().maxCoeff() > 1)
        found.boxes[region] = grown_to(found.boxes[region], place);
    }
  }
  return found;
}

}  // namespace

double spacing_of(const ShapeSamples& samples) {
  return samples.radius / std::sqrt(static_cast<double>(samples.size()));
}

std::optional<SurfaceRegions> find_surface_regions(const RegionRequest& request, const JobControl& control) {
  SurfaceRegions found;
  if (request.kind == RegionKind::segment) {
    std::optional<Segmentation> segments = segment_shape(*request.samples, {}, control);
    if (!segments) return std::nullopt;
    found = of_segments(std::move(*segments), *request.samples);
  } else {
    found = components(request, control);
  }
  if (control.stop.stop_requested()) return std::nullopt;
  found.kind = request.kind;
  found.shape_revision = request.shape_revision;
  return found;
}

}  // namespace archetype
