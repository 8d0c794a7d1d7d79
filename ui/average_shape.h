// The average of many shapes, as a ghost behind the one in view: what the boxes have to stand for.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

#include "core/base/job_control.h"
#include "core/session/latest_worker.h"
#include "render/scene.h"

namespace archetype {

struct AverageRequest {
  std::filesystem::path project;
  std::uint64_t revision = 0;  // of the collection
};

struct AverageShape {
  std::shared_ptr<const PointGeometry> points;
  // Of the points: the more shapes have something there, the farther from the backdrop.
  std::shared_ptr<const Colours> over_dark;
  std::shared_ptr<const Colours> over_light;
  std::size_t shapes = 0;
  std::uint64_t revision = 0;  // as asked for
};

// At most this many shapes are read; of more, as many drawn at random.
inline constexpr std::size_t most_averaged_shapes = 100;

// What the worker runs: the places where at least a tenth of the shapes have samples, as they stand in the
// template's frame where they are fitted, else as they are. About 2 ms a shape. Nothing if cancelled, or
// without shapes.
std::optional<AverageShape> make_average_shape(const AverageRequest& request, const JobControl& control);

using AverageWorker = LatestWorker<AverageRequest, AverageShape>;

}  // namespace archetype
