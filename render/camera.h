// The camera: plain data that turns about a target, and the functions that move it and look through it.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>

namespace archetype {

// A turntable: +y is up and stays up. Angles in radians, lengths in the scene's units.
struct Camera {
  glm::dvec3 target{0, 0, 0};  // what it turns about; in the middle of the picture
  double yaw = 0.65;           // 0: the eye stands on +z of the target (front), pi/2: on +x (right side)
  double pitch = 0.4;          // > 0: from above; in [-pi/2, pi/2]
  double distance = 5;         // of the eye from the target, > 0
  double field_of_view = 0.5;  // vertical, perspective; sets the height of the picture at the target in both
  bool orthographic = false;
  friend bool operator==(const Camera&, const Camera&) = default;
};

// The size of a picture. Pixel coordinates run from its upper left corner to the right and down; the centre
// of the first pixel is (0.5, 0.5).
struct Viewport {
  int width = 1;
  int height = 1;
  friend bool operator==(const Viewport&, const Viewport&) = default;
};

enum class ViewPreset { front, back, right, left, top, bottom, three_quarter };

// Turns about the target by angles; the pitch stops at straight up and down.
void orbit(Camera& camera, double yaw, double pitch);
// Moves so that what was at pixel `from`, at the depth of the target, comes to `to`.
void pan(Camera& camera, const Viewport& viewport, const glm::dvec2& from, const glm::dvec2& to);
// Comes nearer (factor < 1) or goes away, so that what is under the cursor stays there. factor > 0.
void zoom(Camera& camera, const Viewport& viewport, const glm::dvec2& cursor, double factor);
// Turns the camera; target, distance and projection stay.
void look_from(Camera& camera, ViewPreset preset);
// Moves without turning, so that the box between the corners fills the picture but for `margin` (a share of
// it).
void frame(Camera& camera, const Viewport& viewport, const glm::dvec3& low, const glm::dvec3& high,
           double margin = 0.08);
// The same for points, as tightly as they allow; the target comes to the middle of the picture at their mean
// depth. Does nothing without points.
void frame_points(Camera& camera, const Viewport& viewport, std::span<const glm::vec3> points,
                  double margin = 0.08);

// Whether all of the points are in the picture.
bool shows_all(const Camera& camera, const Viewport& viewport, std::span<const glm::vec3> points);

// What a camera saw in one picture, to tell in the next one whether it has to follow.
struct WholeView {
  Camera camera;
  bool whole = false;  // everything was in the picture
};
// Remembers whether the points are in the picture, and says whether some stick out now of what held all there
// was before, by the same camera: another, larger shape has taken its place, or the picture has become
// narrower. A camera that shows a detail, and one that was moved, is left where it is.
bool outgrows(WholeView& before, const Camera& camera, const Viewport& viewport,
              std::span<const glm::vec3> points);

// Between two cameras, for moves that the eye can follow: t = 0 gives `from`, t = 1 gives `to` exactly. Turns
// the shorter way.
Camera blend(const Camera& from, const Camera& to, double t);

glm::dvec3 eye(const Camera& camera);
glm::dvec3 right_axis(const Camera& camera);
glm::dvec3 up_axis(const Camera& camera);
glm::dvec3 back_axis(const Camera& camera);  // from the target to the eye
// Scene units per pixel at the depth of the target.
double pixel_size(const Camera& camera, const Viewport& viewport);

glm::dmat4 view_matrix(const Camera& camera);
glm::dmat4 projection_matrix(const Camera& camera, const Viewport& viewport);

struct Ray {
  glm::dvec3 origin;     // on the near plane
  glm::dvec3 direction;  // unit
};
Ray ray_through(const Camera& camera, const Viewport& viewport, const glm::dvec2& pixel);

// The pixel of a point, or nothing where it lies behind the eye.
std::optional<glm::dvec2> to_screen(const Camera& camera, const Viewport& viewport, const glm::dvec3& point);
// How far in front of the eye a point lies, along the view.
double view_depth(const Camera& camera, const glm::dvec3& point);

}  // namespace archetype
