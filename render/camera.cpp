// Camera maths. Everything in double precision, so that picking agrees with the picture to less than a pixel.
#include "render/camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <limits>

namespace archetype {
namespace {

constexpr double pi = glm::pi<double>();
constexpr double near_share = 0.02;  // of the distance to the target
constexpr double far_share = 200;

double half_height(const Camera& camera) {
  return camera.distance * std::tan(0.5 * camera.field_of_view);
}

double aspect(const Viewport& viewport) {
  return static_cast<double>(viewport.width) / viewport.height;
}

// The point at the depth of the target that a pixel shows.
glm::dvec3 on_target_plane(const Camera& camera, const Viewport& viewport, const glm::dvec2& pixel) {
  const double size = pixel_size(camera, viewport);
  return camera.target + right_axis(camera) * ((pixel.x - 0.5 * viewport.width) * size) -
         up_axis(camera) * ((pixel.y - 0.5 * viewport.height) * size);
}

}  // namespace

glm::dvec3 right_axis(const Camera& camera) {
  return {std::cos(camera.yaw), 0, -std::sin(camera.yaw)};
}

glm::dvec3 back_axis(const Camera& camera) {
  const double level = std::cos(camera.pitch);
  return {level * std::sin(camera.yaw), std::sin(camera.pitch), level * std::cos(camera.yaw)};
}

glm::dvec3 up_axis(const Camera& camera) {
  return glm::cross(back_axis(camera), right_axis(camera));
}

glm::dvec3 eye(const Camera& camera) {
  return camera.target + camera.distance * back_axis(camera);
}

double pixel_size(const Camera& camera, const Viewport& viewport) {
  return 2 * half_height(camera) / viewport.height;
}

void orbit(Camera& camera, double yaw, double pitch) {
  camera.yaw = std::remainder(camera.yaw + yaw, 2 * pi);
  camera.pitch = std::clamp(camera.pitch + pitch, -0.5 * pi, 0.5 * pi);
}

void pan(Camera& camera, const Viewport& viewport, const glm::dvec2& from, const glm::dvec2& to) {
  camera.target += on_target_plane(camera, viewport, from) - on_target_plane(camera, viewport, to);
}

void zoom(Camera& camera, const Viewport& viewport, const glm::dvec2& cursor, double factor) {
  // Scaling eye and target about a point of the cursor's ray leaves the direction of that ray as it is.
  const glm::dvec3 fixed = on_target_plane(camera, viewport, cursor);
  const double distance = std::clamp(camera.distance * factor, 1e-4, 1e6);
  camera.target = fixed + (camera.target - fixed) * (distance / camera.distance);
  camera.distance = distance;
}

void look_from(Camera& camera, ViewPreset preset) {
  switch (preset) {
    case ViewPreset::front:
      camera.yaw = 0, camera.pitch = 0;
      return;
    case ViewPreset::back:
      camera.yaw = pi, camera.pitch = 0;
      return;
    case ViewPreset::right:
      camera.yaw = 0.5 * pi, camera.pitch = 0;
      return;
    case ViewPreset::left:
      camera.yaw = -0.5 * pi, camera.pitch = 0;
      return;
    case ViewPreset::top:
      camera.yaw = 0, camera.pitch = 0.5 * pi;
      return;
    case ViewPreset::bottom:
      camera.yaw = 0, camera.pitch = -0.5 * pi;
      return;
    case ViewPreset::three_quarter:
      camera.yaw = Camera{}.yaw, camera.pitch = Camera{}.pitch;
      return;
  }
}

void frame(Camera& camera, const Viewport& viewport, const glm::dvec3& low, const glm::dvec3& high,
           double margin) {
  camera.target = 0.5 * (low + high);
  const double tan_y = std::tan(0.5 * camera.field_of_view) * (1 - margin);
  const double tan_x = tan_y * aspect(viewport);
  double distance = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 p = glm::dvec3((corner & 1) != 0 ? high.x : low.x, (corner & 2) != 0 ? high.y : low.y,
                                    (corner & 4) != 0 ? high.z : low.z) -
                         camera.target;
    // In perspective a corner that is nearer to the eye by `depth` sees a picture that is smaller by as much.
    const double depth = camera.orthographic ? 0 : glm::dot(p, back_axis(camera));
    distance = std::max(distance, std::abs(glm::dot(p, right_axis(camera))) / tan_x + depth);
    distance = std::max(distance, std::abs(glm::dot(p, up_axis(camera))) / tan_y + depth);
  }
  camera.distance = std::clamp(distance, 1e-4, 1e6);
}

bool shows_all(const Camera& camera, const Viewport& viewport, std::span<const glm::vec3> points) {
  const glm::dvec3 from = eye(camera);
  const glm::dmat3 to_axes =
      glm::transpose(glm::dmat3(right_axis(camera), up_axis(camera), -back_axis(camera)));
  const double tan_y = std::tan(0.5 * camera.field_of_view);
  const double tan_x = tan_y * aspect(viewport);
  return std::ranges::all_of(points, [&](const glm::vec3& point) {
    const glm::dvec3 p = to_axes * (glm::dvec3(point) - from);
    const double depth = camera.orthographic ? camera.distance : p.z;
    return std::abs(p.x) <= tan_x * depth && std::abs(p.y) <= tan_y * depth;
  });
}

bool outgrows(WholeView& before, const Camera& camera, const Viewport& viewport,
              std::span<const glm::vec3> points) {
  const WholeView now{camera, shows_all(camera, viewport, points)};
  const bool outgrown = before.whole && !now.whole && before.camera == camera;
  before = now;
  return outgrown;
}

void frame_points(Camera& camera, const Viewport& viewport, std::span<const glm::vec3> points,
                  double margin) {
  if (points.empty()) return;
  const glm::dmat3 to_axes =
      glm::transpose(glm::dmat3(right_axis(camera), up_axis(camera), back_axis(camera)));
  const auto in_axes = [&](const glm::vec3& point) { return to_axes * glm::dvec3(point); };
  const double tan_y = std::tan(0.5 * camera.field_of_view) * (1 - margin);
  const double tan_x = tan_y * aspect(viewport);
  // With the eye at (x, y, D) a point p is seen if |p.x - x| <= tan_x (D - p.z), and the same for y. So x +
  // tan_x D is at least the largest p.x + tan_x p.z, and -x + tan_x D the largest -p.x + tan_x p.z; the least
  // D meets both. In a parallel view the terms of p.z are not there.
  constexpr double lowest = std::numeric_limits<double>::lowest();
  std::array<double, 4> reach{lowest, lowest, lowest, lowest};  // right, left, up, down
  double nearest = lowest;
  double farthest = -lowest;
  for (const glm::vec3& point : points) {
    const glm::dvec3 p = in_axes(point);
    const double seen_depth = camera.orthographic ? 0 : p.z;
    reach[0] = std::max(reach[0], p.x + tan_x * seen_depth);
    reach[1] = std::max(reach[1], -p.x + tan_x * seen_depth);
    reach[2] = std::max(reach[2], p.y + tan_y * seen_depth);
    reach[3] = std::max(reach[3], -p.y + tan_y * seen_depth);
    nearest = std::max(nearest, p.z);
    farthest = std::min(farthest, p.z);
  }
  const double depth = std::max((reach[0] + reach[1]) / (2 * tan_x), (reach[2] + reach[3]) / (2 * tan_y));
  const double middle = 0.5 * (nearest + farthest);
  camera.distance = std::clamp(camera.orthographic ? depth : depth - middle, 1e-4, 1e6);

  // That settles the place in the direction that is tight; in the other one the points come to the middle in
  // a few steps, each of which moves the eye by what they are off at their middle depth.
  glm::dvec2 place(0.5 * (reach[0] - reach[1]), 0.5 * (reach[2] - reach[3]));
  for (int step = 0; step < 6; ++step) {
    glm::dvec2 low(-lowest);
    glm::dvec2 high(lowest);
    for (const glm::vec3& point : points) {
      const glm::dvec3 p = in_axes(point);
      const double scale = camera.orthographic ? 1 : camera.distance / (camera.distance + middle - p.z);
      const glm::dvec2 seen = (glm::dvec2(p) - place) * scale;
      low = glm::min(low, seen);
      high = glm::max(high, seen);
    }
    place += 0.5 * (low + high);
  }
  camera.target = right_axis(camera) * place.x + up_axis(camera) * place.y + back_axis(camera) * middle;
}

Camera blend(const Camera& from, const Camera& to, double t) {
  if (t >= 1) return to;
  Camera camera = from;
  camera.target = glm::mix(from.target, to.target, t);
  camera.yaw = from.yaw + t * std::remainder(to.yaw - from.yaw, 2 * pi);
  camera.pitch = std::lerp(from.pitch, to.pitch, t);
  camera.distance = from.distance * std::pow(to.distance / from.distance, t);
  camera.field_of_view = std::lerp(from.field_of_view, to.field_of_view, t);
  return camera;
}

glm::dmat4 view_matrix(const Camera& camera) {
  const glm::dvec3 x = right_axis(camera);
  const glm::dvec3 y = up_axis(camera);
  const glm::dvec3 z = back_axis(camera);
  const glm::dvec3 e = eye(camera);
  glm::dmat4 view(1);
  view = glm::row(view, 0, glm::dvec4(x, -glm::dot(x, e)));
  view = glm::row(view, 1, glm::dvec4(y, -glm::dot(y, e)));
  view = glm::row(view, 2, glm::dvec4(z, -glm::dot(z, e)));
  return view;
}

glm::dmat4 projection_matrix(const Camera& camera, const Viewport& viewport) {
  const double far = far_share * camera.distance;
  if (!camera.orthographic)
    return glm::perspective(camera.field_of_view, aspect(viewport), near_share * camera.distance, far);
  // Nothing is cut off behind the eye: in a parallel view it has no place of its own.
  const double y = half_height(camera);
  const double x = y * aspect(viewport);
  return glm::ortho(-x, x, -y, y, -20 * camera.distance, 20 * camera.distance);
}

Ray ray_through(const Camera& camera, const Viewport& viewport, const glm::dvec2& pixel) {
  const glm::dvec3 through = on_target_plane(camera, viewport, pixel);
  if (camera.orthographic) {
    const glm::dvec3 forward = -back_axis(camera);
    return {through - forward * (20 * camera.distance), forward};
  }
  const glm::dvec3 forward = (through - eye(camera)) / camera.distance;  // depth 1 along the view
  return {eye(camera) + forward * (near_share * camera.distance), glm::normalize(forward)};
}

std::optional<glm::dvec2> to_screen(const Camera& camera, const Viewport& viewport, const glm::dvec3& point) {
  const glm::dvec4 clip = projection_matrix(camera, viewport) * (view_matrix(camera) * glm::dvec4(point, 1));
  if (clip.w <= 0) return std::nullopt;
  return glm::dvec2((0.5 + 0.5 * clip.x / clip.w) * viewport.width,
                    (0.5 - 0.5 * clip.y / clip.w) * viewport.height);
}

double view_depth(const Camera& camera, const glm::dvec3& point) {
  return glm::dot(eye(camera) - point, back_axis(camera));
}

}  // namespace archetype
