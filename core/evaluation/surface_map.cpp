// Closest points on triangles, in file coordinates on the way in and on the mean boxes on the way out.
#include "core/evaluation/surface_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"

namespace archetype {

namespace {

// Normalised units, on the mean boxes. What another part's surface has to be nearer by than that of the same
// part, and how far it may be.
constexpr double other_part_cost = 0.1;
constexpr double other_part_reach = 0.5;

// Beyond so many half extents of the fitted box lies what was labelled wrongly.
constexpr double farthest_local = 1.5;

// The triangles of a mesh, or a point set's points as triangles without area, with the element of each.
void collect_triangles(const PolygonMesh& mesh, std::vector<Triangle>& triangles,
                       std::vector<std::uint32_t>& elements) {
  if (mesh.is_point_set()) {
    for (const Vec3& p : mesh.vertices) {
      elements.push_back(static_cast<std::uint32_t>(triangles.size()));
      triangles.push_back({p, p, p});
    }
    return;
  }
  Triangulation cut = triangulate(mesh);
  triangles.reserve(cut.triangles.size());
  for (const auto& [a, b, c] : cut.triangles) {
    triangles.push_back({mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]});
  }
  elements = std::move(cut.faces);
}

Vec3 place(const Triangle& triangle, const Vec3& weights) {
  return weights[0] * triangle[0] + weights[1] * triangle[1] + weights[2] * triangle[2];
}

void check(const LabelledSurface& surface) {
  if (surface.labels.size() != surface.mesh.element_count()) {
    throw PreconditionError("the labels of a surface to map belong to another mesh");
  }
  const auto parts = static_cast<std::int16_t>(surface.fit.parts.size());
  if (std::ranges::any_of(surface.labels, [&](std::int16_t label) { return label >= parts; })) {
    throw PreconditionError("the labels of a surface to map belong to another fit");
  }
}

}  // namespace

std::vector<Box> carrying_boxes(const LabelledSurface& surface) {
  check(surface);
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> elements;
  collect_triangles(surface.mesh, triangles, elements);
  std::vector<Bounds> reaches(surface.fit.parts.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const std::int16_t label = surface.labels[elements[t]];
    if (label < 0) continue;
    const auto part = static_cast<std::size_t>(label);
    for (const Vec3& corner : triangles[t]) {
      const Vec3 q = surface.fit.to_template(surface.frame.to_normalised(corner));
      const Vec3 local = surface.fit.parts[part].box.to_local(q);
      reaches[part].add(local.cwiseMax(-farthest_local).cwiseMin(farthest_local));
    }
  }
  std::vector<Box> boxes;
  for (std::size_t k = 0; k < reaches.size(); ++k) {
    Box& box = boxes.emplace_back(surface.fit.parts[k].box);
    if (reaches[k].empty()) continue;
    const Vec3 half = 0.5 * (reaches[k].half_extent() + Vec3::Ones());
    box.centre = box.to_world(0.5 * reaches[k].centre());
    box.half_extent = box.half_extent.cwiseProduct(half);
  }
  return boxes;
}

SurfaceToTemplate::SurfaceToTemplate(const LabelledSurface& surface, const PartTemplate& part_template)
    : surface_(surface), boxes_(carrying_boxes(surface)) {
  if (boxes_.size() != part_template.parts.size()) {
    throw PreconditionError("the fit of a surface to map is one by another template");
  }
  for (const TemplatePart& part : part_template.parts) mean_boxes_.push_back(part.mean_box());
  collect_triangles(surface.mesh, triangles_, elements_);
  search_ = SurfaceSearch(triangles_);
}

std::optional<PartPoint> SurfaceToTemplate::locate(const Vec3& p) const {
  if (search_.empty()) return {};
  const SurfacePoint nearest = search_.nearest(p);
  const std::int16_t label = surface_.labels[elements_[nearest.triangle]];
  if (label < 0) return {};
  const Vec3 on_surface = place(triangles_[nearest.triangle], nearest.weights);
  const Vec3 q = surface_.fit.to_template(surface_.frame.to_normalised(on_surface));
  const auto part = static_cast<std::size_t>(label);
  const Vec3 local = boxes_[part].to_local(q);
  return PartPoint{label, local, mean_boxes_[part].to_world(local)};
}

TemplateToSurface::TemplateToSurface(const LabelledSurface& surface, const PartTemplate& part_template)
    : parts_(part_template.parts.size()) {
  const std::vector<Box> boxes = carrying_boxes(surface);
  if (boxes.size() != parts_.size()) {
    throw PreconditionError("the fit of a surface to map is one by another template");
  }
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> elements;
  collect_triangles(surface.mesh, triangles, elements);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const std::int16_t label = surface.labels[elements[t]];
    if (label >= 0) parts_[static_cast<std::size_t>(label)].triangles.push_back(triangles[t]);
  }
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    Part& part = parts_[k];
    part.mean = part_template.parts[k].mean_box();
    std::vector<Triangle> canonical = part.triangles;
    for (Triangle& triangle : canonical) {
      for (Vec3& corner : triangle) {
        const Vec3 q = surface.fit.to_template(surface.frame.to_normalised(corner));
        corner = part.mean.to_world(boxes[k].to_local(q));
      }
    }
    part.search = SurfaceSearch(std::move(canonical));
  }
}

std::optional<TemplateToSurface::Found> TemplateToSurface::find(const PartPoint& point) const {
  const Vec3 place_on_mean = point.part < 0
                                 ? point.on_mean
                                 : parts_.at(static_cast<std::size_t>(point.part)).mean.to_world(point.local);
  std::optional<Found> found;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    const Part& part = parts_[k];
    if (part.search.empty()) continue;
    const bool same = static_cast<int>(k) == point.part;
    const SurfacePoint nearest = part.search.nearest(place_on_mean);
    const double distance = std::sqrt(nearest.squared_distance);
    const double cost = distance + (same ? 0 : other_part_cost);
    if (cost >= least || (!same && distance > other_part_reach)) continue;
    least = cost;
    found = {place(part.triangles[nearest.triangle], nearest.weights), static_cast<int>(k)};
  }
  return found;
}

int counterpart(const PartTemplate& from, int index, const PartTemplate& to) {
  if (from == to) return index;
  const std::string& name = from.parts.at(static_cast<std::size_t>(index)).name;
  const auto found = std::ranges::find(to.parts, name, &TemplatePart::name);
  return found == to.parts.end() ? -1 : static_cast<int>(found - to.parts.begin());
}

}  // namespace archetype
