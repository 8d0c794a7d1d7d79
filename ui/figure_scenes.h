// Shapes and templates as scenes of figures.
#pragma once

#include <memory>
#include <optional>

#include "core/io/project.h"
#include "render/camera.h"
#include "render/scene.h"

namespace archetype {

// A shape with its fit, as the project holds it; with its faces where its file is still there.
struct FigureShape {
  ShapeRecord record;
  ShapeSamples samples;
  std::optional<FitRecord> fit;
  std::shared_ptr<const PartTemplate> part_template;  // of the fit
  std::shared_ptr<const MeshGeometry> mesh;           // null: there is no file, or it is a point set
  std::shared_ptr<const PointGeometry> points;        // of a point set, or the samples without a file
  std::shared_ptr<const Colours> part_colours;        // of the faces or points; null without a fit
};
// Nothing if the project has no such shape. Throws FileError where the project cannot be read.
std::optional<FigureShape> load_figure_shape(const Project& project, ShapeId id);

// The shape as it stands in the frame of its template, in the colours of its parts or plain.
void add_shape(Scene& scene, const FigureShape& shape, bool coloured);

struct TemplateDrawing {
  bool spread = true;  // ellipsoids and dashed lines too
  std::optional<std::size_t> highlighted = {};
  Backdrop backdrop = Backdrop::light;
};
// The mean boxes, one a part, solid enough to be seen on paper. Parts that most shapes lack are dashed
// outlines without their spread, unless they are highlighted.
Scene template_scene(const PartTemplate& part_template, const TemplateDrawing& drawing = {});

// From three quarters, so that the scene fills the picture.
Camera figure_camera(const Scene& scene, const Viewport& viewport);

}  // namespace archetype
