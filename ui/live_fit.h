// The fit of the shape in view, computed beside the window while a box is dragged or a number typed.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "core/evaluation/label_elements.h"
#include "core/fitting/alpha_expansion.h"
#include "core/fitting/fit_options.h"
#include "core/fitting/pinned_labels.h"
#include "core/geometry/polygon_mesh.h"
#include "core/session/latest_worker.h"
#include "ui/shape_in_view.h"

namespace archetype {

struct LiveFitRequest {
  std::shared_ptr<const PartTemplate> part_template;
  std::shared_ptr<const ShapeSamples> samples;
  std::shared_ptr<const PolygonMesh> mesh;  // null: the elements are not labelled
  std::shared_ptr<const ViewFit> start;     // of the same shape: fitted on from there while a drag goes on
  bool keep_yaw = false;                    // boxes were made on the shape as it is shown: it stands right
  bool dragging = false;                    // false: all yaws are tried anew
  bool costs = true;                        // what each sample and element costs is wanted, too
  FitOptions options;
  std::vector<PinnedLabel> pinned;      // of the template
  std::uint64_t document_revision = 0;  // history.revision() of the template
  std::uint64_t shape_revision = 0;     // of the shape in view
};

struct LiveFitResult {
  std::shared_ptr<const ViewFit> fit;  // null: it failed, see problem
  std::string problem;
  std::uint64_t document_revision = 0;
  std::uint64_t shape_revision = 0;
  double fit_milliseconds = 0;
  double label_milliseconds = 0;
};

// Templates with the features that their boxes let expect (see template_surface.h). The newest is kept: the
// fit in view and the strip ask for the same one, each on a thread of its own. Thread-safe.
class ExpectedFeatures {
 public:
  std::shared_ptr<const PartTemplate> of(const std::shared_ptr<const PartTemplate>& part_template);

 private:
  std::mutex mutex_;  // held while it is made: who asks meanwhile waits for it
  std::shared_ptr<const PartTemplate> asked_;
  std::shared_ptr<const PartTemplate> made_;
};

// What the worker runs. Keeps what does not change from one fit of the shape to the next.
class LiveFitter {
 public:
  explicit LiveFitter(std::shared_ptr<ExpectedFeatures> expected = std::make_shared<ExpectedFeatures>())
      : expected_(std::move(expected)) {}
  // Nothing when cancelled.
  std::optional<LiveFitResult> run(const LiveFitRequest& request, const JobControl& control);

 private:
  std::vector<std::int16_t> label(const PartTemplate& expecting, const LiveFitRequest& request,
                                  const ShapeFit& fit, const JobControl& control);

  const LabellingGraph& graph(const LiveFitRequest& request);

  std::shared_ptr<ExpectedFeatures> expected_;
  std::shared_ptr<const ShapeSamples> graph_samples_;  // of the graph
  LabellingGraph graph_;
  std::shared_ptr<const PolygonMesh> mesh_;  // of the labeller, as are the samples
  std::shared_ptr<const ShapeSamples> samples_;
  std::optional<ElementLabeller> labeller_;
};

using LiveFitWorker = LatestWorker<LiveFitRequest, LiveFitResult>;

struct LiveFit {
  LiveFit(std::shared_ptr<ExpectedFeatures> expected, std::function<void()> wake)
      : worker([fitter = std::make_shared<LiveFitter>(std::move(expected))](
                   const LiveFitRequest& request,
                   const JobControl& control) { return fitter->run(request, control); },
               std::move(wake)) {}

  LiveFitWorker worker;
  std::uint64_t asked_document = 0;  // of the newest request
  std::uint64_t asked_shape = 0;
  std::shared_ptr<const PartTemplate> asked_look;  // the template that was looked at, if one was
  std::uint64_t shown_document = 0;                // of the fit that the next frame shows
  bool newly_shown = false;                        // the frame being drawn is the first with it
  double fit_milliseconds = 0;                     // of the newest result
  double label_milliseconds = 0;
};

}  // namespace archetype
