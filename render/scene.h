// What is to be drawn, as plain data. Made anew for each picture; the big things in it are shared.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "core/geometry/box.h"
#include "core/model/part_colours.h"
#include "render/geometry.h"

namespace archetype {

using Colours = std::vector<Rgb>;

struct SceneMesh {
  std::shared_ptr<const MeshGeometry> geometry{};
  std::shared_ptr<const Colours> face_colours{};  // one per face of the file; none: `colour` for all
  Rgb colour{200, 198, 194};
  bool surface = true;  // with `edges`: surface and wireframe; without both nothing is drawn
  bool edges = false;
  bool lit = true;  // false: the colours just as they are, for masks
  glm::mat4 transform{1};
};

struct ScenePoints {
  std::shared_ptr<const PointGeometry> geometry{};
  std::shared_ptr<const Colours> colours{};  // one per point; none: `colour` for all
  Rgb colour{200, 198, 194};
  float radius = 0;       // of a splat, scene units; 0: from the spacing of the points
  bool lit = true;        // has no effect without normals
  bool behind = false;    // everything else, in the order of the points: a ghost
  float blend = 0;        // from the positions of the points (0) to their moved ones (1), where there are any
  std::size_t first = 0;  // of the points that are drawn
  std::size_t most = std::numeric_limits<std::size_t>::max();  // so many from there
  glm::mat4 transform{1};
};

struct SceneBox {
  Box box;
  Rgb colour{120, 120, 120};     // of the faces
  std::optional<Rgb> outline{};  // nothing: as the faces
  float fill = 0.16F;            // opacity of the faces; 0 draws only the outline
  float outline_width = 1.6F;    // pixels
  float dash = 0;                // length of a dash and of a gap in pixels; 0: a whole line
};

struct SceneLine {
  glm::vec3 from{0};
  glm::vec3 to{0};
  Rgb colour{120, 120, 120};
  float opacity = 1;
  float width = 1.5F;  // pixels
  float dash = 0;      // as in SceneBox
};

// An ellipsoid by its half axes, drawn as a translucent body: the spread of a part's position.
struct SceneEllipsoid {
  Box axes;  // the box that it touches from inside
  Rgb colour{120, 120, 120};
  float opacity = 0.35F;
};

enum class Backdrop { light, dark, transparent };

struct Scene {
  std::vector<SceneMesh> meshes;
  std::vector<ScenePoints> points;
  std::vector<SceneBox> boxes;
  std::vector<SceneLine> lines;
  std::vector<SceneEllipsoid> ellipsoids;
  Backdrop backdrop = Backdrop::light;
  bool grid = false;  // on the ground, the plane y = ground
  float ground = 0;
  float hidden_lines =
      0.22F;  // opacity of the parts of lines and outlines that something hides; 0: not drawn
};

}  // namespace archetype
