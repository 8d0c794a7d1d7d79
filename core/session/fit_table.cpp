#include "core/session/fit_table.h"

#include <algorithm>
#include <map>
#include <unordered_map>

namespace archetype {
namespace {

void add_parts(FitTable& table, const ShapeFit& fit) {
  std::vector<std::size_t> counts(fit.parts.size());
  for (const std::int16_t label : fit.labels)
    if (label != null_label) ++counts[static_cast<std::size_t>(label)];
  const auto all = static_cast<double>(std::max<std::size_t>(1, fit.labels.size()));
  for (std::size_t i = 0; i < fit.parts.size(); ++i)
    table.parts.push_back({fit.parts[i].present, fit.parts[i].box, static_cast<double>(counts[i]) / all});
}

// Of one template, options and corrections, which the state stands for, a shape has one fit.
bool same_fit(const FitSummary& a, const FitSummary& b) {
  return a.part_template == b.part_template && a.state == b.state && a.yaw_quarters == b.yaw_quarters &&
         a.energy == b.energy;
}

std::unordered_map<ShapeId, const FitTableRow*> rows_by_shape(const FitTable* table) {
  std::unordered_map<ShapeId, const FitTableRow*> rows;
  if (!table) return rows;
  rows.reserve(table->rows.size());
  for (const FitTableRow& row : table->rows) rows[row.summary.shape] = &row;
  return rows;
}

}  // namespace

std::optional<FitTable> read_fit_table(const Project& project, const JobControl& control,
                                       const FitTable* previous) {
  const std::unordered_map<ShapeId, const FitTableRow*> known = rows_by_shape(previous);
  FitTable table;
  table.templates = project.templates();
  std::map<TemplateId, std::size_t> places;
  for (std::size_t i = 0; i < table.templates.size(); ++i) places[table.templates[i].id] = i;
  const std::vector<FitSummary> fits = project.fits();
  table.rows.reserve(fits.size());
  for (const FitSummary& summary : fits) {
    if (control.cancelled()) return std::nullopt;
    if (const auto row = known.find(summary.shape); row != known.end()) {
      const auto place = places.find(summary.part_template);
      if (place != places.end() && same_fit(row->second->summary, summary)) {
        table.rows.push_back({summary, place->second, table.parts.size(), row->second->translation});
        const auto parts = previous->parts_of(*row->second);
        table.parts.insert(table.parts.end(), parts.begin(), parts.end());
        continue;
      }
    }
    // Another program may write between the two readings: a fit that has gone or changed is read next time.
    const std::optional<FitRecord> record = project.fit(summary.shape);
    if (!record || record->part_template != summary.part_template) continue;
    const auto [place, is_new] = places.try_emplace(summary.part_template, table.templates.size());
    if (is_new) {
      std::optional<TemplateRecord> found = project.find_template(summary.part_template);
      if (!found) {
        places.erase(place);
        continue;
      }
      table.templates.push_back(std::move(*found));
    }
    table.rows.push_back({summary, place->second, table.parts.size(), record->fit.translation});
    add_parts(table, record->fit);
  }
  return table;
}

}  // namespace archetype
