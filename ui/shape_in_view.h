// The one shape that the viewport shows and the live fit follows.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/polygon_mesh.h"
#include "core/io/project.h"
#include "core/model/shape.h"
#include "core/model/shape_fit.h"

namespace archetype {

// What fitting the active template to it gave last; of a template that may be some edits old while a drag
// goes on.
struct ViewFit {
  std::shared_ptr<const PartTemplate> part_template;  // the one that was fitted
  ShapeFit fit;
  std::vector<std::int16_t> element_labels;  // a part index per face of the file, or null_label
  std::vector<double> sample_costs;          // see core/fitting/sample_costs.h
  std::vector<float> element_costs;          // the same for every face
};

// The names of the parts that must exist and were not found.
std::vector<std::string> missing_parts(const ViewFit& view);
// What the energy would be if no part had to exist: 1000 more a part says nothing to a person, and its bar
// would hide the others.
FitEnergy energy_without_missing(const ViewFit& view);

struct ShapeInView {
  std::optional<ShapeRecord> record;        // nothing: no shape is in view
  std::shared_ptr<const PolygonMesh> mesh;  // file coordinates; null until it is read, or if the file is gone
  std::shared_ptr<const ShapeSamples> samples;  // null until they are read
  std::string problem;                          // why there is no mesh: one line for a person
  std::shared_ptr<const ViewFit> fit;           // null: none yet

  std::uint64_t shape_revision = 0;  // changes when the record, mesh or samples do
  std::uint64_t fit_revision = 0;    // changes when the fit does
};

}  // namespace archetype
