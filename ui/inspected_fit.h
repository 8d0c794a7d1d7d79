// One shape as the project holds it, and one fit of it taken apart: made beside the window.
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/evaluation/fit_inspection.h"
#include "core/evaluation/label_elements.h"
#include "core/evaluation/surface_map.h"
#include "core/session/cluster_terms.h"
#include "core/session/fit_alternatives.h"
#include "core/session/latest_worker.h"
#include "ui/shape_display.h"

namespace archetype {

struct InspectedShape {
  ShapeRecord record;
  std::shared_ptr<const ShapeSamples> samples;
  std::shared_ptr<const PolygonMesh> mesh;            // null: the file is gone
  ShapeDisplay display;                               // its mesh can be picked
  std::optional<FitRecord> fit;                       // nothing: it was not fitted yet
  std::shared_ptr<const PartTemplate> part_template;  // of that fit; null without it
  std::vector<std::int16_t> element_labels;           // of that fit; empty where they are not known
  std::vector<TemplateRecord> templates;              // the current ones of the project
  ContentHash state;  // fit_state() of these: what a fit of a shape without corrections has
};

// What it is to be read of; another fit of the shape is another request.
struct LoadInspected {
  std::filesystem::path project;
  ShapeId shape = 0;
  TemplateId part_template = 0;
  ContentHash state{};
  double energy = 0;
  friend bool operator==(const LoadInspected&, const LoadInspected&) = default;
};
struct LoadedInspected {
  LoadInspected of;
  std::shared_ptr<const InspectedShape> shape;  // null where it could not be read
  std::string problem;                          // why
};
std::optional<LoadedInspected> load_inspected(const LoadInspected& request, const JobControl& control);

// A fit with all that is drawn of it. Stays where it is: its maps refer to it.
struct FitLook {
  std::shared_ptr<const InspectedShape> shape;
  std::shared_ptr<const PartTemplate> part_template;
  ShapeFit fit;
  FitInspection terms;
  std::vector<std::int16_t> element_labels;         // empty: no mesh
  std::array<std::vector<float>, 3> element_terms;  // shape_to_template, features, smoothness; or empty
  std::optional<SurfaceToTemplate> to_template;     // if the places of it are wanted, and there is a mesh
  std::optional<TemplateToSurface> to_surface;
};

struct LookRequest {
  std::shared_ptr<const InspectedShape> shape;
  std::shared_ptr<const PartTemplate> part_template;
  std::shared_ptr<const ShapeFit> fit;
  std::vector<PinnedLabel> pinned;
  bool places = true;  // they are wanted: not while the alternations are scrubbed through
};
struct LookResult {
  LookRequest of;
  std::shared_ptr<const FitLook> look;  // null: it could not be taken apart
};

// What the worker runs. Keeps what does not change from one fit of a shape to the next.
class FitLooker {
 public:
  std::optional<LookResult> run(const LookRequest& request, const JobControl& control);

 private:
  std::shared_ptr<const InspectedShape> shape_;  // of the labeller
  std::optional<ElementLabeller> labeller_;
};

// The place of the template that a point of the shape (normalised coordinates) stands at; nothing where it
// belongs to no part.
std::optional<PartPoint> place_on_template(const FitLook& look, const Vec3& point);
// Where that place of the template `from` is on the shape, normalised coordinates; nothing where the shape
// has nothing like it.
std::optional<Vec3> place_on_shape(const FitLook& look, const PartTemplate& from, const PartPoint& place);

struct AlternativesRequest {
  std::filesystem::path project;
  std::shared_ptr<const InspectedShape> shape;
  PinnedParts pinned;
  friend bool operator==(const AlternativesRequest&, const AlternativesRequest&) = default;
};
struct Alternatives {
  AlternativesRequest of;
  std::vector<std::shared_ptr<const PartTemplate>> templates;  // those of the shape, in their order
  std::vector<FitAlternative> fits;
  // What each yaw costs beside that, as other shapes say (kept_yaw_costs()); nothing where the project does
  // not keep it.
  std::optional<std::array<double, 4>> yaw_costs;
};
std::optional<std::shared_ptr<const Alternatives>> make_alternatives(const AlternativesRequest& request,
                                                                     const JobControl& control);

struct ClusterRequest {
  std::filesystem::path project;
  TemplateId part_template = 0;
  std::uint64_t revision = 0;  // of the table of fits: another one, and it is made anew
  friend bool operator==(const ClusterRequest&, const ClusterRequest&) = default;
};
struct ClusterResult {
  ClusterRequest of;
  ClusterTerms terms;
};
std::optional<ClusterResult> read_cluster(const ClusterRequest& request, const JobControl& control);

}  // namespace archetype
