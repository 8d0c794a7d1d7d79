// The co-aligned points of many shapes in the form that is drawn: read beside the window.
#pragma once

#include <atomic>
#include <filesystem>
#include <memory>

#include "core/session/coaligned_cloud.h"
#include "core/session/latest_worker.h"
#include "render/scene.h"
#include "ui/cloud_choice.h"

namespace archetype {

// How far the reading is, for another thread to look at.
struct CloudProgress {
  std::atomic<std::size_t> done = 0;
  std::atomic<std::size_t> total = 0;
};

struct CloudContentRequest {
  std::filesystem::path project;
  CloudRequest what;
  std::shared_ptr<CloudProgress> progress;
};

struct CloudContent {
  std::shared_ptr<const PointGeometry> points;  // rigid; moved: deformed
  std::vector<CloudPoint> of;                   // one per point
  std::vector<CloudShape> shapes;
  std::vector<TemplateRecord> templates;
  std::vector<float> displacement;  // of each point by the deformation, normalised shape units
  float largest_displacement = 0;   // that colours tell apart: a round number that few exceed
  std::size_t samples = 0;
  Sharpness sharpness;
};

// What the worker runs. Nothing if cancelled. Throws FileError.
std::optional<std::shared_ptr<const CloudContent>> read_cloud(const CloudContentRequest& request,
                                                              const JobControl& control);
using CloudReader = LatestWorker<CloudContentRequest, std::shared_ptr<const CloudContent>>;

// One per point. `kept`: for each template the part that keeps its colours while all others are dimmed, -1
// where it has none of them; empty: all keep theirs. About 5 ms for a million.
std::shared_ptr<const Colours> cloud_colours(const CloudContent& content, CloudColour by,
                                             const std::vector<int>& kept = {});

// The points of some shapes of the cloud alone, given by their indices, ascending.
std::shared_ptr<const PointGeometry> points_of_shapes(const CloudContent& content,
                                                      const std::vector<std::uint32_t>& shapes);

}  // namespace archetype
