// The translucent bodies of a scene (boxes, ellipsoids) and its lines, in the form in which they are drawn.
#pragma once

#include <glm/gtc/type_precision.hpp>
#include <vector>

#include "render/camera.h"
#include "render/scene.h"

namespace archetype {

struct FaceVertex {
  glm::vec3 position;
  glm::vec3 normal;
  glm::u8vec4 colour;
};

struct LineInstance {
  glm::vec3 from;
  glm::vec3 to;
  glm::u8vec4 colour;
  float width;
  float dash;
};

// Triangles, the farthest first by the middle of each face. Where faces cut through each other that order is
// not exact; at the low opacities in use the difference is a few hundredths of a colour.
std::vector<FaceVertex> sorted_faces(const Scene& scene, const Camera& camera);

// The lines of the scene and the outlines of its boxes.
std::vector<LineInstance> collect_lines(const Scene& scene);

}  // namespace archetype
