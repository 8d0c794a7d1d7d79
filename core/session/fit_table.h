// What the fits of a collection say, as tables: what lists, plots and maps of many shapes are made of.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/base/job_control.h"
#include "core/io/project.h"

namespace archetype {

// One part on one shape.
struct PartValues {
  bool present = false;
  Box box;           // fitted, in the template's frame; the mean box where the part is absent
  double share = 0;  // of the shape's samples, 0 to 1
};

struct FitTableRow {
  FitSummary summary;
  std::size_t part_template = 0;  // an index into FitTable::templates
  std::size_t first_part = 0;     // an index into FitTable::parts
  Vec3 translation = Vec3::Zero();
};

struct FitTable {
  std::vector<TemplateRecord> templates;  // the current ones in their order, then others that fits still have
  std::vector<FitTableRow> rows;          // one per fitted shape, ordered by the shapes' names
  std::vector<PartValues> parts;          // of all rows

  // One per part of the row's template.
  std::span<const PartValues> parts_of(const FitTableRow& row) const {
    return std::span(parts).subspan(row.first_part, templates[row.part_template].part_template.parts.size());
  }
};

// About 30 microseconds a shape; those of `previous`, a table of the same project or null, cost 4 where their
// fit is still the one that it has. Nothing if cancelled. Throws FileError.
std::optional<FitTable> read_fit_table(const Project& project, const JobControl& control,
                                       const FitTable* previous = nullptr);

}  // namespace archetype
