// Small pictures of shapes for grids and lists.
#pragma once

#include <span>

#include "core/base/picture.h"
#include "render/renderer.h"

namespace archetype {

struct ThumbnailOptions {
  int size = 256;  // pixels, width and height
  Backdrop backdrop = Backdrop::transparent;
  glm::mat4 transform{1};  // of the shape, before it is looked at
  // What fills the picture instead of the shape, after the transformation: then all shapes of a kind are
  // drawn at one scale. A shape that is larger is still drawn whole. Empty: the shape.
  std::vector<glm::vec3> framed = {};
  bool mask = false;  // the colours just as they are, each pixel of one of them
};

// The camera of all thumbnails: from a three-quarter view, so that the points fill the picture.
Camera thumbnail_camera(std::span<const glm::vec3> framed, Viewport size);
// That of the picture of a shape with these points.
Camera shape_camera(const std::vector<glm::vec3>& positions, const ThumbnailOptions& options);

// A shape from a three-quarter view that fills the picture, in single colours or one per face or point; null
// colours: neutral. Supersampled. About 1 ms for 5,000 triangles in software. Draws with OpenGL: needs the
// renderer's context.
Picture mesh_thumbnail(Renderer& renderer, const std::shared_ptr<const MeshGeometry>& geometry,
                       std::shared_ptr<const Colours> face_colours, const ThumbnailOptions& options = {});
Picture point_thumbnail(Renderer& renderer, const std::shared_ptr<const PointGeometry>& geometry,
                        std::shared_ptr<const Colours> colours, const ThumbnailOptions& options = {});

// The colour of each part index (null_label: grey), for `face_colours` above and in scenes.
std::shared_ptr<const Colours> colours_of_labels(std::span<const std::int16_t> labels,
                                                 const PartTemplate* part_template = nullptr);

}  // namespace archetype
