// The points of many shapes in the space of their templates (figure 8), as arrays to draw and pick.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/base/job_control.h"
#include "core/evaluation/coalign.h"
#include "core/io/project.h"

namespace archetype {

struct CloudRequest {
  std::vector<ShapeId> shapes;          // those without a fit are left out
  std::size_t most_points = 1'000'000;  // with more samples, every shape gives the same share of its own
  unsigned threads = 0;                 // 0: all
};

struct CloudPoint {
  std::uint32_t shape = 0;  // an index into CoalignedCloud::shapes
  std::int16_t part = null_label;
};

struct CloudShape {
  ShapeId id = 0;
  std::size_t part_template = 0;  // an index into CoalignedCloud::templates
};

// About 45 bytes a point.
struct CoalignedCloud {
  std::vector<CloudShape> shapes;         // in the order of the request
  std::vector<TemplateRecord> templates;  // that these were fitted by
  // One entry per point each, in an order drawn at random, but always the same: the first n points are an
  // even choice of all, whatever n is.
  std::vector<CloudPoint> points;
  std::vector<Eigen::Vector3f> rigid;  // in the template's frame, turned and moved with the shape
  std::vector<Eigen::Vector3f> deformed;
  std::vector<Eigen::Vector3f> normals;  // of the rigid ones
  std::size_t samples = 0;               // of these shapes; more than points where there were too many
  Sharpness sharpness;                   // over all samples
};

// About 5 ms a shape of 1,000 samples and thread. Nothing if cancelled. Throws FileError.
std::optional<CoalignedCloud> read_coaligned_cloud(const Project& project, const CloudRequest& request,
                                                   const JobControl& control);

}  // namespace archetype
