// From labels of samples to labels of the file's faces (section 5, "Segmentation accuracy").
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/job_control.h"
#include "core/fitting/alpha_expansion.h"
#include "core/fitting/fit_options.h"
#include "core/fitting/pinned_labels.h"
#include "core/geometry/polygon_mesh.h"
#include "core/model/part_template.h"
#include "core/model/shape.h"
#include "core/model/shape_fit.h"

namespace archetype {

// What labelling the faces of one shape needs that does not depend on the fit: made once where many fits of
// one shape are labelled, as while a box is dragged. Making it costs about 40 ms for 20,000 faces, each
// labelling about 10 ms.
class ElementLabeller {
 public:
  // Throws PreconditionError if the samples are not of this mesh. Keeps copies of what it needs of the mesh;
  // the samples must stay. Cancelled, it is of no use.
  ElementLabeller(const PolygonMesh& mesh, const ShapeSamples& samples, const FitOptions& options,
                  const JobControl& control = {});

  // The part index of every face of the file (of every point of a point set), in file order; null_label where
  // the fit calls the place an outlier. A cut over the faces where the mesh is usable as a surface, a vote of
  // the nearest samples where it is a soup. What lies nearest to a pinned sample, which the fit has labelled
  // so, has its label. Nothing if cancelled.
  std::vector<std::int16_t> label(const PartTemplate& part_template, const ShapeFit& fit,
                                  const JobControl& control = {},
                                  std::span<const PinnedLabel> pinned = {}) const;

  // Of every element the mean of what the nearest samples have, by their weights. values: one per sample.
  std::vector<float> interpolate(const std::vector<double>& values) const;

 private:
  static constexpr std::size_t nearest_count = 3;
  struct Element {
    Vec3 point;  // normalised: the centre of the face, or the point
    double area_share = 0;
    std::array<std::uint32_t, nearest_count> nearest{};  // samples, nearest first
    std::array<double, nearest_count> weights{};         // by inverse squared distance, together 1
  };
  std::vector<std::int16_t> cut(const PartTemplate& part_template, const ShapeFit& fit,
                                const JobControl& control, std::span<const PinnedLabel> pinned) const;
  std::vector<std::int16_t> vote(const ShapeFit& fit, std::span<const PinnedLabel> pinned) const;

  const ShapeSamples* samples_;
  FitOptions options_;
  bool surface_ = false;  // the mesh has an adjacency worth a cut
  std::vector<Element> elements_;
  // Of a surface:
  LabellingGraph faces_;
  LabellingGraph points_;
  std::vector<std::vector<std::uint32_t>> around_;  // each sample's nearest ones, itself first
};

// The same for one fit. Half a minute for two million faces.
std::vector<std::int16_t> label_elements(const PolygonMesh& mesh, const ShapeSamples& samples,
                                         const PartTemplate& part_template, const ShapeFit& fit,
                                         const FitOptions& options, const JobControl& control = {},
                                         std::span<const PinnedLabel> pinned = {});

}  // namespace archetype
