#include "core/session/shape_map.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "core/model/part_names.h"
#include "core/session/nearest_shapes.h"

namespace archetype {
namespace {

using Matrix = Eigen::MatrixXd;

constexpr double farthest = 4;  // deviations
constexpr Eigen::Index most_parameters = 240;

// Parameters as columns, a shape a row. NaN: the shape has no such part.
struct Parameters {
  Matrix values;
  std::vector<std::string> names;
};

constexpr std::array<const char*, part_parameter_count> parameter_names{
    "left or right", "height above ground", "front or back", "width", "height", "depth"};

void add_names(Parameters& parameters, const std::string& part) {
  for (const char* name : parameter_names) parameters.names.push_back(part + " " + name);
  parameters.names.push_back(part + " there or not");
}

constexpr Eigen::Index columns_a_part = part_parameter_count + 1;

bool bounded(const Box& box) {
  return box.centre.allFinite() && box.half_extent.allFinite() && box.centre.cwiseAbs().maxCoeff() < 1e6 &&
         box.half_extent.cwiseAbs().maxCoeff() < 1e6;
}

Parameters parameters_of_template(const FitTable& table, const std::vector<std::size_t>& rows,
                                  std::size_t part_template) {
  const std::vector<TemplatePart>& parts = table.templates[part_template].part_template.parts;
  Parameters parameters;
  for (const TemplatePart& part : parts) add_names(parameters, part.name);
  parameters.values = Matrix::Constant(static_cast<Eigen::Index>(rows.size()),
                                       static_cast<Eigen::Index>(parts.size()) * columns_a_part, NAN);
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const std::span<const PartValues> values = table.parts_of(table.rows[rows[r]]);
    for (std::size_t p = 0; p < parts.size(); ++p) {
      auto cells = parameters.values.row(static_cast<Eigen::Index>(r))
                       .segment(static_cast<Eigen::Index>(p) * columns_a_part, columns_a_part);
      cells[columns_a_part - 1] = values[p].present ? 1 : 0;
      if (!values[p].present || !bounded(values[p].box)) continue;
      const auto z = part_parameters(parts[p], values[p].box);
      for (std::size_t i = 0; i < z.size(); ++i)
        cells[static_cast<Eigen::Index>(i)] = std::clamp(z[i], -farthest, farthest);
    }
  }
  return parameters;
}

// The parts' bounding box along the axes of the template.
void add_box(Bounds& bounds, const Box& box) {
  const Mat3 turned = box.orientation.toRotationMatrix().cwiseAbs();
  const Vec3 reach = turned * box.half_extent;
  bounds.add(box.centre - reach);
  bounds.add(box.centre + reach);
}

Parameters parameters_of_labels(const FitTable& table, const std::vector<std::size_t>& rows) {
  std::map<int, std::vector<std::string>> labels;
  for (const TemplateRecord& record : table.templates)
    for (const TemplatePart& part : record.part_template.parts) labels[part.label].push_back(part.name);
  std::map<int, Eigen::Index> places;
  Parameters parameters;
  for (const auto& [label, names] : labels) {
    places[label] = static_cast<Eigen::Index>(places.size());
    add_names(parameters, common_part_name(names));
  }
  parameters.values = Matrix::Constant(static_cast<Eigen::Index>(rows.size()),
                                       static_cast<Eigen::Index>(places.size()) * columns_a_part, NAN);
  std::vector<Bounds> bounds(places.size());
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const FitTableRow& row = table.rows[rows[r]];
    const std::span<const PartValues> values = table.parts_of(row);
    const std::vector<TemplatePart>& parts = table.templates[row.part_template].part_template.parts;
    std::ranges::fill(bounds, Bounds{});
    for (std::size_t p = 0; p < parts.size(); ++p)
      if (values[p].present && bounded(values[p].box))
        add_box(bounds[static_cast<std::size_t>(places[parts[p].label])], values[p].box);
    for (std::size_t l = 0; l < bounds.size(); ++l) {
      auto cells = parameters.values.row(static_cast<Eigen::Index>(r))
                       .segment(static_cast<Eigen::Index>(l) * columns_a_part, columns_a_part);
      cells[columns_a_part - 1] = bounds[l].empty() ? 0 : 1;
      if (bounds[l].empty()) continue;
      cells.head<3>() = (bounds[l].centre() + row.translation).transpose();
      cells.segment<3>(3) = bounds[l].half_extent().transpose();
    }
  }
  return parameters;
}

// Each column less its mean, and NaN taken for that; divided by its deviation where that is asked for.
void centre(Matrix& values, bool standardise) {
  for (Eigen::Index c = 0; c < values.cols(); ++c) {
    auto column = values.col(c);
    double sum = 0;
    double count = 0;
    for (const double value : column)
      if (std::isfinite(value)) sum += value, ++count;
    const double mean = count > 0 ? sum / count : 0;
    double squares = 0;
    for (double& value : column) {
      value = std::isfinite(value) ? value - mean : 0;
      squares += value * value;
    }
    const double stddev = count > 0 ? std::sqrt(squares / count) : 0;
    const bool presence = c % columns_a_part == columns_a_part - 1;
    if (standardise && !presence && stddev > 1e-9)
      for (double& value : column) value = std::clamp(value / stddev, -farthest, farthest);
    // A part that half of the shapes lack says as much as one parameter that varies by its deviation.
    if (presence) column *= 2;
  }
}

// Those that vary most, where there are more than can be had quickly.
void keep_most(Parameters& parameters) {
  if (parameters.values.cols() <= most_parameters) return;
  std::vector<Eigen::Index> order(static_cast<std::size_t>(parameters.values.cols()));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  const Eigen::VectorXd squares = parameters.values.colwise().squaredNorm();
  std::ranges::stable_sort(order, [&](Eigen::Index a, Eigen::Index b) { return squares[a] > squares[b]; });
  order.resize(static_cast<std::size_t>(most_parameters));
  Matrix kept(parameters.values.rows(), most_parameters);
  std::vector<std::string> names;
  for (Eigen::Index c = 0; c < most_parameters; ++c) {
    kept.col(c) = parameters.values.col(order[static_cast<std::size_t>(c)]);
    names.push_back(parameters.names[static_cast<std::size_t>(order[static_cast<std::size_t>(c)])]);
  }
  parameters.values = std::move(kept);
  parameters.names = std::move(names);
}

// The two that weigh most; what weighs less than half as much as the first is not worth a word.
std::string meaning_of(const Eigen::VectorXd& axis, const std::vector<std::string>& names) {
  Eigen::Index first = 0;
  const double most = axis.cwiseAbs().maxCoeff(&first);
  Eigen::VectorXd others = axis.cwiseAbs();
  others[first] = 0;
  Eigen::Index second = 0;
  const double next = others.maxCoeff(&second);
  std::string meaning = names[static_cast<std::size_t>(first)];
  if (next > most / 2) meaning += ", " + names[static_cast<std::size_t>(second)];
  return meaning;
}

void project(const Parameters& parameters, ShapeMap& map) {
  const Matrix& values = parameters.values;
  if (values.rows() < 2 || values.cols() < 1) return;
  const Matrix covariance = values.transpose() * values / static_cast<double>(values.rows());
  const Eigen::SelfAdjointEigenSolver<Matrix> solver(covariance);
  const double all = std::max(covariance.trace(), 0.0);
  for (int a = 0; a < std::min<int>(2, static_cast<int>(values.cols())); ++a) {
    const Eigen::Index which = values.cols() - 1 - a;
    Eigen::VectorXd axis = solver.eigenvectors().col(which);
    Eigen::Index largest = 0;
    axis.cwiseAbs().maxCoeff(&largest);
    if (axis[largest] < 0) axis = -axis;
    const double variance = std::max(0.0, solver.eigenvalues()[which]);
    if (!(all > 1e-12) || !(variance > 1e-9 * all)) continue;
    const Eigen::VectorXd along = values * axis;
    for (std::size_t i = 0; i < map.points.size(); ++i)
      map.points[i].at[static_cast<std::size_t>(a)] = static_cast<float>(along[static_cast<Eigen::Index>(i)]);
    map.axes[static_cast<std::size_t>(a)] = {variance / all, meaning_of(axis, parameters.names)};
  }
}

}  // namespace

std::optional<ShapeMap> map_of_shapes(const FitTable& table, std::optional<std::size_t> part_template,
                                      const JobControl& control) {
  ShapeMap map;
  std::vector<std::size_t> rows;
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    const FitTableRow& row = table.rows[r];
    if (part_template && row.part_template != *part_template) continue;
    rows.push_back(r);
    map.points.push_back(
        {row.summary.shape, row.part_template, {}, row.summary.status == FitStatus::outlier});
  }
  if (rows.empty()) return map;
  Parameters parameters =
      part_template ? parameters_of_template(table, rows, *part_template) : parameters_of_labels(table, rows);
  if (control.cancelled()) return std::nullopt;
  centre(parameters.values, !part_template);
  keep_most(parameters);
  if (control.cancelled()) return std::nullopt;
  project(parameters, map);
  return control.cancelled() ? std::nullopt : std::optional(std::move(map));
}

}  // namespace archetype
