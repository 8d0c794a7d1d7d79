// Rays against triangles, splats and boxes.
#include "render/picking.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "render/convert.h"
#include "render/splat.h"

namespace archetype {
namespace {

void pick_mesh(const SceneMesh& mesh, std::size_t object, const Ray& ray, Pick& best) {
  if (!mesh.geometry || (!mesh.surface && !mesh.edges)) return;
  // The direction is not made unit again: distances stay those along the ray of the scene.
  const glm::dmat4 inverse = glm::inverse(glm::dmat4(mesh.transform));
  const glm::dvec3 origin(inverse * glm::dvec4(ray.origin, 1));
  const glm::dvec3 direction(inverse * glm::dvec4(ray.direction, 0));
  const auto hit = mesh.geometry->tree.first_hit(mesh.geometry->positions, origin, direction, best.distance);
  if (!hit) return;
  best = {PickKind::face, object, mesh.geometry->faces[hit->triangle], hit->distance,
          ray.origin + hit->distance * ray.direction};
}

void pick_points(const ScenePoints& points, std::size_t object, const Camera& camera,
                 const Viewport& viewport, const glm::dvec2& pixel, const Ray& ray, Pick& best) {
  if (!points.geometry) return;
  const glm::dmat4 transform(points.transform);
  const glm::dmat4 to_clip = projection_matrix(camera, viewport) * view_matrix(camera) * transform;
  const double pixels_per_unit = (camera.orthographic ? 1.0 : camera.distance) / pixel_size(camera, viewport);
  const double radius = splat_radius(points) * pixels_per_unit;
  const std::size_t last = last_drawn(points);
  for (std::size_t i = points.first; i < last; ++i) {
    const glm::dvec4 point(drawn_position(points, i), 1);
    const glm::dvec4 clip = to_clip * point;
    if (clip.w <= 0 || std::abs(clip.z) > clip.w) continue;
    const double drawn_radius =
        std::clamp(radius / clip.w, 0.5 * least_splat_diameter, 0.5 * largest_splat_diameter);
    const double x = (0.5 + 0.5 * clip.x / clip.w) * viewport.width - pixel.x;
    const double y = (0.5 - 0.5 * clip.y / clip.w) * viewport.height - pixel.y;
    if (x * x + y * y > drawn_radius * drawn_radius) continue;
    // A splat faces the eye: it meets the ray where the ray is as deep as its middle.
    const glm::dvec3 position(transform * point);
    const glm::dvec3 back = back_axis(camera);
    const double distance = glm::dot(position - ray.origin, back) / glm::dot(ray.direction, back);
    if (distance < best.distance) best = {PickKind::point, object, i, distance, position};
  }
}

}  // namespace

Pick pick_surface(const Scene& scene, const Camera& camera, const Viewport& viewport,
                  const glm::dvec2& pixel) {
  const Ray ray = ray_through(camera, viewport, pixel);
  Pick best;
  best.distance = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) pick_mesh(scene.meshes[i], i, ray, best);
  for (std::size_t i = 0; i < scene.points.size(); ++i)
    pick_points(scene.points[i], i, camera, viewport, pixel, ray, best);
  return best.kind == PickKind::nothing ? Pick{} : best;
}

std::vector<Pick> pick_boxes(const Scene& scene, const Ray& ray) {
  std::vector<Pick> picks;
  for (std::size_t i = 0; i < scene.boxes.size(); ++i) {
    const Box& box = scene.boxes[i].box;
    const Vec3 origin = box.orientation.conjugate() * (to_eigen(ray.origin) - box.centre);
    const Vec3 direction = box.orientation.conjugate() * to_eigen(ray.direction);
    // Slabs: the ray is inside from the last entry to the first exit.
    double enter = -std::numeric_limits<double>::infinity();
    double leave = std::numeric_limits<double>::infinity();
    std::size_t enter_face = 0;
    std::size_t leave_face = 0;
    for (int k = 0; k < 3; ++k) {
      if (direction[k] == 0) {
        if (std::abs(origin[k]) > box.half_extent[k]) leave = -std::numeric_limits<double>::infinity();
        continue;
      }
      const bool forward = direction[k] > 0;
      const auto low_face = 2 * static_cast<std::size_t>(k);
      const double a = ((forward ? -1 : 1) * box.half_extent[k] - origin[k]) / direction[k];
      const double b = ((forward ? 1 : -1) * box.half_extent[k] - origin[k]) / direction[k];
      if (a > enter) enter = a, enter_face = forward ? low_face : low_face + 1;
      if (b < leave) leave = b, leave_face = forward ? low_face + 1 : low_face;
    }
    if (enter > leave || leave < 0) continue;
    const double distance = enter >= 0 ? enter : leave;
    picks.push_back({PickKind::box, i, enter >= 0 ? enter_face : leave_face, distance,
                     ray.origin + distance * ray.direction});
  }
  std::stable_sort(picks.begin(), picks.end(),
                   [](const Pick& a, const Pick& b) { return a.distance < b.distance; });
  return picks;
}

}  // namespace archetype
