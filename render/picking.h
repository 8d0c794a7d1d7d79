// What lies under the cursor. A pick is a value: nothing is drawn for it, and it is exact.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "render/camera.h"
#include "render/scene.h"

namespace archetype {

enum class PickKind { nothing, face, point, box };

struct Pick {
  PickKind kind = PickKind::nothing;
  std::size_t object = 0;   // index into the scene's meshes, points or boxes
  std::size_t element = 0;  // face of the file or point; of a box 0..5: low x, high x, low y, …
  double distance = 0;      // along the ray
  glm::dvec3 position{0};   // in the scene
};

// The nearest face of the file, or point whose splat covers the pixel (boxes do not count). Meshes need their
// tree: geometry.tree = TriangleTree(geometry.positions). Logarithmic in
// the faces, linear in the points: about 2 ms for 100,000.
Pick pick_surface(const Scene& scene, const Camera& camera, const Viewport& viewport,
                  const glm::dvec2& pixel);

// All boxes under the ray, the nearest first: clicking again on the same place may take the next one. From
// inside of a box its far side counts.
std::vector<Pick> pick_boxes(const Scene& scene, const Ray& ray);

}  // namespace archetype
