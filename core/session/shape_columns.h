// Numbers of shapes that lists are sorted by, filters bound and histograms show.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/session/fit_table.h"
#include "core/session/shape_row.h"

namespace archetype {

// Lengths are in normalised units, in the frame of the template that the shape was fitted by.
enum class ShapeQuantity {
  name,  // no number: the order of the rows
  elements,
  energy,  // the sum of the terms that follow
  shape_to_template,
  template_to_shape,
  features,
  deformation,
  smoothness,
  existence,
  part_x,  // the centre of a part's box
  part_y,
  part_z,
  part_half_x,  // its half extents, along its own axes
  part_half_y,
  part_half_z,
  part_share,  // of the shape's samples, 0 to 1; 0 where the part is absent
  similarity   // the distance of deformation parameters to another shape; 0: the same
};

// Parts count by their names, so that one column goes over all templates: those that learning spawns keep the
// names of the parts that they began with.
struct ShapeColumn {
  ShapeQuantity quantity = ShapeQuantity::name;
  std::string part = {};  // for the quantities of parts
  ShapeId shape = 0;      // for `similarity`: the other shape
  friend bool operator==(const ShapeColumn&, const ShapeColumn&) = default;
};

bool is_of_part(ShapeQuantity quantity);
// Whether it can be told only with a table of fits; the others are known from the rows alone.
bool needs_fit_table(const ShapeColumn& column);
// "energy", "seat: half size y", "unlike chair_00012".
std::string column_title(const ShapeColumn& column, std::span<const ShapeRow> rows);
// "Half size y": without the part.
const char* quantity_title(ShapeQuantity quantity);
// For scripts and settings: "energy", "part-half-y"; parse throws Error for an unknown one.
std::string_view quantity_name(ShapeQuantity quantity);
ShapeQuantity parse_quantity(std::string_view name);

// The names of the parts of the templates in use, in their order, each once.
std::vector<std::string> part_names(const FitTable& table);

// Rows and the table of their fits, put together. Both must outlive it. The table may be a little older or
// newer than the rows, or missing.
class ShapeTable {
 public:
  ShapeTable(std::span<const ShapeRow> rows, const FitTable* table);

  std::span<const ShapeRow> rows() const { return rows_; }
  const FitTable* fits() const { return table_; }
  // Of a row; null where it is not known.
  const FitTableRow* fit(std::size_t row) const { return fits_[row]; }
  // By the row, which has a fit; null where its template has no part of this name.
  const PartValues* part(std::size_t row, const std::string& name) const;

 private:
  std::span<const ShapeRow> rows_;
  const FitTable* table_;
  std::vector<const FitTableRow*> fits_;
};

// One per row; not a number where the row has none. Cost: a millisecond for 10,000 rows.
std::vector<double> column_values(const ShapeTable& shapes, const ShapeColumn& column);

// Columns to begin with: the energy, and the sizes of parts that vary most in the first template.
std::vector<ShapeColumn> telling_columns(const FitTable& table, std::size_t most);

// How many bins hold how many of the values; what is not finite is left out.
struct Histogram {
  double low = 0;   // of the first bin
  double high = 1;  // of the last bin, > low
  std::vector<std::size_t> counts;
  std::size_t total = 0;
};
// Over the range of all values but the outmost hundredth of them at either end, where it is far from the
// rest: these are counted in the first and the last bin. `counted` holds which of them count (indices);
// the range is that of all, so that it stands still while a filter changes.
Histogram histogram(std::span<const double> values, std::span<const std::size_t> counted, std::size_t bins);

}  // namespace archetype
