// Points carried from the surface of one shape to that of another through the boxes of their parts (section
// 5, "Correspondence accuracy").
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/geometry/polygon_mesh.h"
#include "core/geometry/surface_search.h"
#include "core/model/part_template.h"
#include "core/model/shape.h"
#include "core/model/shape_fit.h"

namespace archetype {

// A point of a shape as its template sees it.
struct PartPoint {
  int part = 0;               // of the template
  Vec3 local = Vec3::Zero();  // in coordinates of the part's fitted box, see Box; its surface lies at +-1
};

// A surface, or a point set, with its labels and the fit that they come from: the elements' part indices as
// label_elements() gives them. All must stay while it is used.
struct LabelledSurface {
  const PolygonMesh& mesh;
  const ShapeFrame& frame;
  const ShapeFit& fit;
  std::span<const std::int16_t> labels;
};

// From a shape to its template.
class SurfaceToTemplate {
 public:
  explicit SurfaceToTemplate(const LabelledSurface& surface);

  // Of the point of the surface that is nearest to p (file coordinates); nothing where the surface belongs to
  // no part, or there is no surface.
  std::optional<PartPoint> locate(const Vec3& p) const;

 private:
  LabelledSurface surface_;
  std::vector<Triangle> triangles_;  // file coordinates
  std::vector<std::uint32_t> elements_;
  SurfaceSearch search_;
};

// From a template to a shape.
// Differs from the paper, which takes the nearest sample of the co-aligned shapes: the nearest point of the
// surface, and only of the same part. The surface of a part is brought to the part's mean box by its scales,
// not by the offsets of figure 8, which fold where a part is thicker than its box.
class TemplateToSurface {
 public:
  TemplateToSurface(const LabelledSurface& surface, const PartTemplate& part_template);

  // The point of that part's surface (file coordinates) that is nearest on the part's mean box; nothing for a
  // part that the shape lacks.
  std::optional<Vec3> find(const PartPoint& point) const;

 private:
  struct Part {
    Box mean;
    std::vector<Triangle> triangles;  // file coordinates
    SurfaceSearch search;             // over the same on the mean box
  };
  std::vector<Part> parts_;
};

// The part of another template that stands for part `index` of `from`: the same one if the templates are the
// same or one came from the other by learning, that is, the part of the same name; -1 if there is none.
int counterpart(const PartTemplate& from, int index, const PartTemplate& to);

}  // namespace archetype
