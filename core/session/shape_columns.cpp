#include "core/session/shape_columns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <unordered_map>

#include "core/base/error.h"

namespace archetype {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

struct QuantityText {
  ShapeQuantity quantity;
  std::string_view name;
  const char* title;
};

constexpr std::array texts{
    QuantityText{ShapeQuantity::name, "name", "Name"},
    QuantityText{ShapeQuantity::elements, "faces", "Faces or points"},
    QuantityText{ShapeQuantity::energy, "energy", "Energy"},
    QuantityText{ShapeQuantity::shape_to_template, "shape-to-template", "Shape to template"},
    QuantityText{ShapeQuantity::template_to_shape, "template-to-shape", "Template to shape"},
    QuantityText{ShapeQuantity::features, "features", "Features"},
    QuantityText{ShapeQuantity::deformation, "deformation", "Deformation"},
    QuantityText{ShapeQuantity::smoothness, "smoothness", "Smoothness"},
    QuantityText{ShapeQuantity::existence, "existence", "Existence"},
    QuantityText{ShapeQuantity::part_x, "part-x", "Centre x"},
    QuantityText{ShapeQuantity::part_y, "part-y", "Centre y"},
    QuantityText{ShapeQuantity::part_z, "part-z", "Centre z"},
    QuantityText{ShapeQuantity::part_half_x, "part-half-x", "Half size x"},
    QuantityText{ShapeQuantity::part_half_y, "part-half-y", "Half size y"},
    QuantityText{ShapeQuantity::part_half_z, "part-half-z", "Half size z"},
    QuantityText{ShapeQuantity::part_share, "part-share", "Share of the shape"},
    QuantityText{ShapeQuantity::similarity, "similarity", "Similarity"},
};

const QuantityText& text_of(ShapeQuantity quantity) {
  return *std::ranges::find(texts, quantity, &QuantityText::quantity);
}

std::optional<std::size_t> find_part(const PartTemplate& part_template, const std::string& name) {
  const auto found = std::ranges::find(part_template.parts, name, &TemplatePart::name);
  if (found == part_template.parts.end()) return std::nullopt;
  return static_cast<std::size_t>(found - part_template.parts.begin());
}

double term(const FitEnergy& energy, ShapeQuantity quantity) {
  switch (quantity) {
    case ShapeQuantity::shape_to_template:
      return energy.shape_to_template;
    case ShapeQuantity::template_to_shape:
      return energy.template_to_shape;
    case ShapeQuantity::features:
      return energy.features;
    case ShapeQuantity::deformation:
      return energy.deformation;
    case ShapeQuantity::smoothness:
      return energy.smoothness;
    case ShapeQuantity::existence:
      return energy.existence;
    default:
      return energy.total();
  }
}

double value_of_part(const PartValues& part, ShapeQuantity quantity) {
  if (quantity == ShapeQuantity::part_share) return part.present ? part.share : 0;
  if (!part.present) return none;
  const bool is_centre = quantity <= ShapeQuantity::part_z;
  const auto first = is_centre ? ShapeQuantity::part_x : ShapeQuantity::part_half_x;
  const int axis = static_cast<int>(quantity) - static_cast<int>(first);
  return is_centre ? part.box.centre[axis] : part.box.half_extent[axis];
}

std::vector<double> part_values(const ShapeTable& shapes, const ShapeColumn& column) {
  std::vector<double> values(shapes.rows().size(), none);
  if (!shapes.fits()) return values;
  std::vector<std::optional<std::size_t>> places;  // of the part, by template
  for (const TemplateRecord& record : shapes.fits()->templates)
    places.push_back(find_part(record.part_template, column.part));
  for (std::size_t i = 0; i < values.size(); ++i) {
    const FitTableRow* fit = shapes.fit(i);
    if (!fit || !places[fit->part_template]) continue;
    values[i] = value_of_part(shapes.fits()->parts_of(*fit)[*places[fit->part_template]], column.quantity);
  }
  return values;
}

// Deformation parameters in standard deviations of the part. A part that only one of two shapes has counts
// as if all of its parameters were three of them apart.
constexpr double apart = 6 * 3.0 * 3.0;

double distance2(const TemplatePart& of, const PartValues& a, const PartValues& b) {
  if (a.present != b.present) return apart;
  if (!a.present) return 0;
  constexpr double least = 0.01;  // of a standard deviation: parts of templates made by hand may have none
  const Vec3 centre = (a.box.centre - b.box.centre).cwiseQuotient(of.position.stddev.cwiseMax(least));
  const Vec3 size = (a.box.half_extent - b.box.half_extent).cwiseQuotient(of.scale.stddev.cwiseMax(least));
  return centre.squaredNorm() + size.squaredNorm();
}

// The template of the one shape says what is far, and which part of another template is which, by name.
std::vector<double> distances(const ShapeTable& shapes, ShapeId to) {
  std::vector<double> values(shapes.rows().size(), none);
  if (!shapes.fits()) return values;
  const FitTable& table = *shapes.fits();
  const auto reference =
      std::ranges::find(table.rows, to, [](const FitTableRow& row) { return row.summary.shape; });
  if (reference == table.rows.end()) return values;
  const PartTemplate& mine = table.templates[reference->part_template].part_template;
  const std::span<const PartValues> own = table.parts_of(*reference);
  std::vector<std::vector<std::optional<std::size_t>>> places;  // by template and part of `mine`
  for (std::size_t t = 0; t < table.templates.size(); ++t) {
    auto& of = places.emplace_back();
    for (std::size_t k = 0; k < mine.parts.size(); ++k)
      of.push_back(t == reference->part_template
                       ? std::optional(k)
                       : find_part(table.templates[t].part_template, mine.parts[k].name));
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    const FitTableRow* fit = shapes.fit(i);
    if (!fit) continue;
    const std::span<const PartValues> other = table.parts_of(*fit);
    std::ptrdiff_t unmatched = std::ranges::count(other, true, &PartValues::present);
    double sum = 0;
    for (std::size_t k = 0; k < own.size(); ++k) {
      const std::optional<std::size_t> place = places[fit->part_template][k];
      sum += distance2(mine.parts[k], own[k], place ? other[*place] : PartValues{});
      if (place && other[*place].present) --unmatched;
    }
    sum += apart * static_cast<double>(std::max<std::ptrdiff_t>(unmatched, 0));
    values[i] = std::sqrt(sum / static_cast<double>(6 * std::max<std::size_t>(own.size(), 1)));
  }
  return values;
}

double quantile(const std::vector<double>& sorted, double share) {
  return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

}  // namespace

bool is_of_part(ShapeQuantity quantity) {
  return quantity >= ShapeQuantity::part_x && quantity <= ShapeQuantity::part_share;
}

bool needs_fit_table(const ShapeColumn& column) {
  return is_of_part(column.quantity) || column.quantity == ShapeQuantity::similarity;
}

const char* quantity_title(ShapeQuantity quantity) {
  return text_of(quantity).title;
}

std::string_view quantity_name(ShapeQuantity quantity) {
  return text_of(quantity).name;
}

ShapeQuantity parse_quantity(std::string_view name) {
  const auto found = std::ranges::find(texts, name, &QuantityText::name);
  if (found != texts.end()) return found->quantity;
  std::string known;
  for (const QuantityText& text : texts) known += (known.empty() ? "" : ", ") + std::string(text.name);
  throw Error("expected one of " + known + ", not \"" + std::string(name) + "\"");
}

std::string column_title(const ShapeColumn& column, std::span<const ShapeRow> rows) {
  const std::string title = quantity_title(column.quantity);
  if (is_of_part(column.quantity)) return column.part + ": " + title;
  if (column.quantity != ShapeQuantity::similarity) return title;
  const auto row = std::ranges::find(rows, column.shape, &ShapeRow::id);
  return row == rows.end() ? title : title + " to " + row->name;
}

std::vector<std::string> part_names(const FitTable& table) {
  std::vector<std::string> names;
  for (const TemplateRecord& record : table.templates) {
    if (!record.current) continue;
    for (const TemplatePart& part : record.part_template.parts)
      if (std::ranges::find(names, part.name) == names.end()) names.push_back(part.name);
  }
  return names;
}

std::vector<ShapeColumn> telling_columns(const FitTable& table, std::size_t most) {
  std::vector<std::pair<double, ShapeColumn>> sizes;
  if (!table.templates.empty())
    for (const TemplatePart& part : table.templates.front().part_template.parts)
      for (int axis = 0; axis < 3; ++axis) {
        const auto quantity = static_cast<ShapeQuantity>(static_cast<int>(ShapeQuantity::part_half_x) + axis);
        sizes.emplace_back(part.scale.stddev[axis], ShapeColumn{.quantity = quantity, .part = part.name});
      }
  std::ranges::stable_sort(sizes, std::greater(), [](const auto& size) { return size.first; });
  std::vector<ShapeColumn> columns{{.quantity = ShapeQuantity::energy}};
  for (const auto& [stddev, column] : sizes)
    if (columns.size() < most) columns.push_back(column);
  return columns;
}

ShapeTable::ShapeTable(std::span<const ShapeRow> rows, const FitTable* table)
    : rows_(rows), table_(table), fits_(rows.size()) {
  if (!table) return;
  std::unordered_map<ShapeId, const FitTableRow*> by_shape;
  by_shape.reserve(table->rows.size());
  for (const FitTableRow& row : table->rows) by_shape.emplace(row.summary.shape, &row);
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (const auto found = by_shape.find(rows[i].id); found != by_shape.end()) fits_[i] = found->second;
}

const PartValues* ShapeTable::part(std::size_t row, const std::string& name) const {
  const FitTableRow* fit = fits_[row];
  if (!fit) return nullptr;
  const auto place = find_part(table_->templates[fit->part_template].part_template, name);
  return place ? &table_->parts_of(*fit)[*place] : nullptr;
}

std::vector<double> column_values(const ShapeTable& shapes, const ShapeColumn& column) {
  if (is_of_part(column.quantity)) return part_values(shapes, column);
  if (column.quantity == ShapeQuantity::similarity) return distances(shapes, column.shape);
  std::vector<double> values(shapes.rows().size(), none);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const ShapeRow& row = shapes.rows()[i];
    if (column.quantity == ShapeQuantity::elements)
      values[i] = static_cast<double>(row.element_count);
    else if (row.fit && column.quantity != ShapeQuantity::name)
      values[i] = term(row.fit->energy, column.quantity);
  }
  return values;
}

Histogram histogram(std::span<const double> values, std::span<const std::size_t> counted, std::size_t bins) {
  Histogram result;
  result.counts.resize(std::max<std::size_t>(bins, 1));
  std::vector<double> sorted;
  std::ranges::copy_if(values, std::back_inserter(sorted), [](double v) { return std::isfinite(v); });
  if (sorted.empty()) return result;
  std::ranges::sort(sorted);
  // One shape that nothing explains must not press all others into one bin.
  const double inner_low = quantile(sorted, 0.01);
  const double inner_high = quantile(sorted, 0.99);
  const double reach = 1.0 * (inner_high - inner_low);
  result.low = std::max(sorted.front(), inner_low - reach);
  result.high = std::min(sorted.back(), inner_high + reach);
  if (!(result.high > result.low)) {
    const double around = std::max(0.5 * std::abs(result.low), 1e-6);
    result.low -= around;
    result.high += around;
  }
  const auto last = static_cast<double>(result.counts.size() - 1);
  const double scale = static_cast<double>(result.counts.size()) / (result.high - result.low);
  for (const std::size_t i : counted) {
    if (!std::isfinite(values[i])) continue;
    const double bin = std::clamp(std::floor((values[i] - result.low) * scale), 0.0, last);
    ++result.counts[static_cast<std::size_t>(bin)];
    ++result.total;
  }
  return result;
}

}  // namespace archetype
