// Arrays of the cloud become geometry and colours.
#include "ui/cloud_content.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "ui/heat_map.h"
#include "ui/picture_marks.h"

namespace archetype {
namespace {

std::vector<glm::vec3> to_glm(const std::vector<Eigen::Vector3f>& points) {
  std::vector<glm::vec3> result;
  result.reserve(points.size());
  for (const Eigen::Vector3f& p : points) result.emplace_back(p.x(), p.y(), p.z());
  return result;
}

// 1, 2 or 5 times a power of ten, not below the value.
float round_number(float value) {
  if (value <= 0) return 1;
  const float power = std::pow(10.F, std::floor(std::log10(value)));
  for (const float step : {1.F, 2.F, 5.F})
    if (value <= step * power) return step * power;
  return 10 * power;
}

float largest_of_most(std::vector<float> values) {
  if (values.empty()) return 1;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(values.size() * 95 / 100);
  std::nth_element(values.begin(), at, values.end());
  return round_number(*at);
}

// As wide as neighbouring samples of one shape are apart, less where many shapes lie over each other: the
// sharpness is to be seen.
float spacing_of(std::size_t points, std::size_t shapes, const glm::vec3& low, const glm::vec3& high) {
  const glm::vec3 s = high - low;
  const float area = 2 * (s.x * s.y + s.y * s.z + s.z * s.x);
  const float each = static_cast<float>(points) / static_cast<float>(std::max<std::size_t>(shapes, 1));
  const float crowd = std::pow(static_cast<float>(std::max<std::size_t>(shapes, 1)), 0.3F);
  return 0.55F * std::sqrt(area / std::max(each, 1.F)) / crowd;
}

// Of nearly all points: a few that lie far away shall not make the others small. Their order is random, so
// the first ones stand for all.
void set_bounds(PointGeometry& points) {
  constexpr std::size_t most = 20'000;
  const std::size_t count = std::min(most, points.positions.size());
  if (count == 0) return;
  std::vector<float> values;
  for (int axis = 0; axis < 3; ++axis) {
    values.clear();
    for (std::size_t i = 0; i < count; ++i) {
      values.push_back(points.positions[i][axis]);
      values.push_back(points.moved[i][axis]);
    }
    std::ranges::sort(values);
    const std::size_t left_out = values.size() / 500;
    points.low[axis] = values[left_out];
    points.high[axis] = values[values.size() - 1 - left_out];
  }
}

// Neighbours in the list differ much: the golden angle.
Rgb colour_of_shape(std::size_t number) {
  const double hue = std::fmod(static_cast<double>(number) * 0.618033988749895, 1.0) * 6;
  const double light = 0.62 + 0.16 * static_cast<double>(number % 3);
  const auto channel = [&](double shift) {
    const double at = std::fmod(hue + shift, 6.0);
    const double level = std::clamp(std::abs(at - 3) - 1, 0.0, 1.0);
    return static_cast<std::uint8_t>(std::lround(255 * light * (0.3 + 0.7 * level)));
  };
  return {channel(0), channel(4), channel(2)};
}

}  // namespace

std::optional<std::shared_ptr<const CloudContent>> read_cloud(const CloudContentRequest& request,
                                                              const JobControl& control) {
  JobControl watched = control;
  watched.report = [&](std::size_t done, std::size_t total, std::string_view) {
    request.progress->total = total;
    request.progress->done = done;
  };
  std::optional<CoalignedCloud> cloud =
      read_coaligned_cloud(Project::open(request.project), request.what, watched);
  if (!cloud) return std::nullopt;
  auto content = std::make_shared<CloudContent>();
  auto points = std::make_shared<PointGeometry>();
  points->positions = to_glm(cloud->rigid);
  points->moved = to_glm(cloud->deformed);
  points->normals = to_glm(cloud->normals);
  content->displacement.reserve(points->positions.size());
  for (std::size_t i = 0; i < points->positions.size(); ++i)
    content->displacement.push_back(glm::distance(points->positions[i], points->moved[i]));
  set_bounds(*points);
  points->spacing = spacing_of(points->positions.size(), cloud->shapes.size(), points->low, points->high);
  content->largest_displacement = largest_of_most(content->displacement);
  content->points = std::move(points);
  content->of = std::move(cloud->points);
  content->shapes = std::move(cloud->shapes);
  content->templates = std::move(cloud->templates);
  content->samples = cloud->samples;
  content->sharpness = cloud->sharpness;
  return content;
}

std::shared_ptr<const Colours> cloud_colours(const CloudContent& content, CloudColour by,
                                             const std::vector<int>& kept) {
  auto colours = std::make_shared<Colours>();
  colours->reserve(content.of.size());
  // By template and part, with null_label in front.
  std::vector<std::vector<Rgb>> of_parts;
  for (const TemplateRecord& record : content.templates) {
    const PartTemplate& part_template = record.part_template;
    std::vector<Rgb>& row = of_parts.emplace_back();
    for (int part = null_label; part < static_cast<int>(part_template.parts.size()); ++part)
      row.push_back(part_colour(part_template, part));
  }
  std::vector<Rgb> of_shapes;
  for (std::size_t i = 0; i < content.shapes.size(); ++i) of_shapes.push_back(colour_of_shape(i));
  for (std::size_t i = 0; i < content.of.size(); ++i) {
    const CloudPoint& point = content.of[i];
    switch (by) {
      case CloudColour::part:
        colours->push_back(of_parts[content.shapes[point.shape].part_template]
                                   [static_cast<std::size_t>(point.part - null_label)]);
        break;
      case CloudColour::shape:
        colours->push_back(of_shapes[point.shape]);
        break;
      case CloudColour::displacement:
        colours->push_back(heat_colour(content.displacement[i] / content.largest_displacement));
        break;
    }
    if (!kept.empty() && point.part != kept[content.shapes[point.shape].part_template])
      colours->back() = dimmed(colours->back());
  }
  return colours;
}

std::shared_ptr<const PointGeometry> points_of_shapes(const CloudContent& content,
                                                      const std::vector<std::uint32_t>& shapes) {
  auto points = std::make_shared<PointGeometry>();
  points->spacing = content.points->spacing;
  points->low = content.points->low;
  points->high = content.points->high;
  for (std::size_t i = 0; i < content.of.size(); ++i) {
    if (!std::ranges::binary_search(shapes, content.of[i].shape)) continue;
    points->positions.push_back(content.points->positions[i]);
    points->moved.push_back(content.points->moved[i]);
    points->normals.push_back(content.points->normals[i]);
  }
  return points;
}

}  // namespace archetype
