// A shape of the strip: small enough to be fitted and drawn again at every step of a drag.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/job_control.h"
#include "core/io/project.h"
#include "ui/live_fit.h"
#include "ui/viewport_scene.h"

namespace archetype {

// What does not change with the template.
struct StripShape {
  ShapeId id = 0;
  std::string problem;  // not empty: why it cannot be shown; the rest is empty then
  ShapeRecord record;
  std::shared_ptr<const ShapeSamples> samples;
  ShapeDisplay display;  // a coarse mesh whose faces are its triangles; the samples where there is none
  // Of triangle i, the samples whose labels it takes: those from voters[voter_begins[i]] on, before those of
  // the next triangle. Samples on its face of the file, or else the nearest one.
  std::vector<std::uint32_t> voters;
  std::vector<std::uint32_t> voter_begins{0};
};

struct LoadStripShape {
  std::filesystem::path project;
  ShapeId shape = 0;
};
// What a worker runs. Nothing if cancelled; a file that is gone is drawn by its samples. About half a second
// for 20,000 faces.
using LoadedStripShape = std::shared_ptr<const StripShape>;
std::optional<LoadedStripShape> load_strip_shape(const LoadStripShape& request, const JobControl& control);

// Of the triangles by the majority of their voters, and of the samples.
ShapeColours strip_colours(const StripShape& shape, const PartTemplate& part_template, const ShapeFit& fit);

struct StripFit {
  ViewFit view;  // its faces are not labelled
  ShapeColours colours;
};

struct StripFitRequest {
  std::shared_ptr<const PartTemplate> part_template;
  std::vector<std::shared_ptr<const StripShape>> shapes;
  std::vector<std::shared_ptr<const StripFit>> starts;  // as many; null where there is none
  bool keep_yaw = false;                                // see LiveFitRequest
  bool dragging = false;
  std::uint64_t document_revision = 0;
};

struct StripFitResult {
  std::vector<ShapeId> shapes;
  std::vector<std::shared_ptr<const StripFit>> fits;  // null where it failed
  std::string problem;                                // why the first of these failed
  std::uint64_t document_revision = 0;
  double milliseconds = 0;
};

// What a worker runs. Keeps what does not change from one fit of a shape to the next.
class StripFitters {
 public:
  explicit StripFitters(std::shared_ptr<ExpectedFeatures> expected) : expected_(std::move(expected)) {}
  // Fits all shapes, on all threads. Nothing when cancelled.
  std::optional<StripFitResult> run(const StripFitRequest& request, const JobControl& control);

 private:
  std::shared_ptr<ExpectedFeatures> expected_;
  std::map<ShapeId, LiveFitter> fitters_;
};

}  // namespace archetype
