// Which shapes of a collection are shown, and in which order: one filter for all lists, clouds, maps and
// plots.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/session/shape_columns.h"

namespace archetype {

struct ValueRange {
  ShapeColumn column;
  double low = 0;
  double high = 0;
  friend bool operator==(const ValueRange&, const ValueRange&) = default;
};

struct PartCondition {
  std::string part;
  bool present = true;
  friend bool operator==(const PartCondition&, const PartCondition&) = default;
};

// A shape is shown if nothing here speaks against it. What is hidden is listed, rather than what is shown, so
// that templates that learning brings are seen.
struct ShapeFilter {
  std::string name = {};  // words, each of which the name has to hold; case does not matter
  std::vector<TemplateId> hidden_templates = {};
  std::vector<FitStatus> hidden_statuses = {};
  bool hide_unfitted = false;
  std::vector<PartCondition> parts = {};  // a shape without a fit has none
  std::vector<ValueRange> ranges = {};    // both ends are within; a shape without the value is out
  friend bool operator==(const ShapeFilter&, const ShapeFilter&) = default;
};

bool is_empty(const ShapeFilter& filter);  // shows everything
// Conditions, as a person counts them: for a button that says how many there are.
std::size_t condition_count(const ShapeFilter& filter);
bool needs_fit_table(const ShapeFilter& filter);

// The range of a column; null if it has none.
const ValueRange* find_range(const ShapeFilter& filter, const ShapeColumn& column);
void set_range(ShapeFilter& filter, const ShapeColumn& column, double low, double high);
void clear_range(ShapeFilter& filter, const ShapeColumn& column);
// In or out of one of the lists of what is hidden.
template <typename T>
void toggle_hidden(std::vector<T>& hidden, const T& each) {
  if (std::erase(hidden, each) == 0) hidden.push_back(each);
}

struct ShapeOrder {
  ShapeColumn column;
  bool descending = false;
  friend bool operator==(const ShapeOrder&, const ShapeOrder&) = default;
};

// The rows to show, in the order asked for; those without the value come last, and equal ones by name. About
// 5 ms for 10,000 rows and a few conditions.
std::vector<std::size_t> shown_rows(const ShapeTable& shapes, const ShapeFilter& filter,
                                    const ShapeOrder& order);

}  // namespace archetype
