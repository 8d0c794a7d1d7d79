// The geometry of shapes on the graphics card.
#pragma once

#include "render/gl/vertices.h"
#include "render/identity_cache.h"
#include "render/scene.h"

namespace archetype {

struct UploadedGeometry {
  gl::Buffer positions;
  gl::Buffer normals;
  gl::Buffer edge_distances;
  gl::Buffer moved;
  gl::VertexArray vertices;
  std::size_t byte_count() const {
    return positions.byte_count() + normals.byte_count() + edge_distances.byte_count() + moved.byte_count();
  }
};

struct UploadedColours {
  gl::Buffer colours;  // RGBA, one per corner or point
  std::size_t byte_count() const { return colours.byte_count(); }
};

// Uploads what is not there yet and forgets what is no longer drawn.
class Uploads {
 public:
  const gl::VertexArray& mesh(const SceneMesh& mesh);
  const gl::VertexArray& points(const ScenePoints& points);
  void end_picture();  // once after each picture

  std::size_t byte_count() const { return geometry_.byte_count() + colours_.byte_count(); }

 private:
  static constexpr std::size_t byte_budget = 384U << 20U;
  static constexpr std::uint64_t idle_pictures = 600;
  IdentityCache<UploadedGeometry> geometry_{byte_budget, idle_pictures};
  IdentityCache<UploadedColours> colours_{byte_budget / 4, idle_pictures};
};

}  // namespace archetype
