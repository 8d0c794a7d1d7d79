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
  int part = 0;                 // of the template; negative: of none that the template at hand has
  Vec3 local = Vec3::Zero();    // in coordinates of the part's box, see Box; its surface lies near +-1
  Vec3 on_mean = Vec3::Zero();  // the same place on the part's mean box: where a part of another one may be
};

// A surface, or a point set, with its labels and the fit that they come from: the elements' part indices as
// label_elements() gives them. All must stay while it is used.
struct LabelledSurface {
  const PolygonMesh& mesh;
  const ShapeFrame& frame;
  const ShapeFit& fit;
  std::span<const std::int16_t> labels;
};

// The boxes by which points are carried, one per part: half-way between the fitted one and the bounds of the
// surface with its label, so that ends come to ends. Differs from the paper, which has the fitted ones: they
// lie inside what tapers or leans, by another share for every shape (landmarks within 0.05 of the diameter:
// generated chairs 83 -> 91 %, planes 68 -> 74 %; with the bounds alone a few faces of a wrong label count
// for too much).
std::vector<Box> carrying_boxes(const LabelledSurface& surface);

// From a shape to its template.
class SurfaceToTemplate {
 public:
  SurfaceToTemplate(const LabelledSurface& surface, const PartTemplate& part_template);

  // Of the point of the surface that is nearest to p (file coordinates); nothing where the surface belongs to
  // no part, or there is no surface.
  std::optional<PartPoint> locate(const Vec3& p) const;

  const SurfaceSearch& search() const { return search_; }  // over the surface in file coordinates

 private:
  LabelledSurface surface_;
  std::vector<Box> boxes_;
  std::vector<Box> mean_boxes_;
  std::vector<Triangle> triangles_;  // file coordinates
  std::vector<std::uint32_t> elements_;
  SurfaceSearch search_;
};

// From a template to a shape.
// Differs from the paper, which takes the nearest sample of the co-aligned shapes: the nearest point of the
// surface, of the same part unless another is clearly nearer, as where two shapes part wing and body at
// different places. The surface of a part is brought to the part's mean box by its scales, not by the offsets
// of figure 8, which fold where a part is thicker than its box.
class TemplateToSurface {
 public:
  TemplateToSurface(const LabelledSurface& surface, const PartTemplate& part_template);

  struct Found {
    Vec3 position = Vec3::Zero();  // on the surface, file coordinates
    int part = 0;
  };
  // The point of the surface that is nearest on the mean boxes. If the shape lacks the part, one of a
  // neighbouring part does, but nothing is found where that is far away: an arm has no counterpart on a shape
  // without arms, the foot of its post has one on the seat.
  std::optional<Found> find(const PartPoint& point) const;

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
