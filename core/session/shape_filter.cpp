#include "core/session/shape_filter.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numeric>

namespace archetype {
namespace {

char lower(char c) {
  return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

std::vector<std::string> words(const std::string& text) {
  std::vector<std::string> found;
  std::string word;
  for (const char c : text + " ") {
    if (std::isspace(static_cast<unsigned char>(c)) == 0)
      word += lower(c);
    else if (!word.empty())
      found.push_back(std::exchange(word, {}));
  }
  return found;
}

// `word` is in small letters.
bool holds(const std::string& name, const std::string& word) {
  const auto same = [](char a, char b) { return lower(a) == b; };
  return std::search(name.begin(), name.end(), word.begin(), word.end(), same) != name.end();
}

template <typename T>
bool contains(const std::vector<T>& all, const T& each) {
  return std::ranges::find(all, each) != all.end();
}

bool passes(const ShapeRow& row, const ShapeFilter& filter, const std::vector<std::string>& wanted) {
  for (const std::string& word : wanted)
    if (!holds(row.name, word)) return false;
  if (!row.fit) return !filter.hide_unfitted;
  return !contains(filter.hidden_templates, row.fit->part_template) &&
         !contains(filter.hidden_statuses, row.fit->status);
}

bool has_parts(const ShapeTable& shapes, std::size_t row, const std::vector<PartCondition>& conditions) {
  return std::ranges::all_of(conditions, [&](const PartCondition& condition) {
    const PartValues* part = shapes.part(row, condition.part);
    return (part && part->present) == condition.present;
  });
}

void sort_rows(std::vector<std::size_t>& shown, const ShapeTable& shapes, const ShapeOrder& order) {
  if (order.column.quantity == ShapeQuantity::name) {
    if (order.descending) std::ranges::reverse(shown);
    return;
  }
  std::vector<double> keys = column_values(shapes, order.column);
  for (double& key : keys) key = std::isnan(key) ? HUGE_VAL : order.descending ? -key : key;
  std::ranges::stable_sort(shown, {}, [&](std::size_t row) { return keys[row]; });
}

}  // namespace

bool is_empty(const ShapeFilter& filter) {
  return filter == ShapeFilter{};
}

std::size_t condition_count(const ShapeFilter& filter) {
  return (words(filter.name).empty() ? 0U : 1U) + filter.hidden_templates.size() +
         filter.hidden_statuses.size() + (filter.hide_unfitted ? 1U : 0U) + filter.parts.size() +
         filter.ranges.size();
}

bool needs_fit_table(const ShapeFilter& filter) {
  return !filter.parts.empty() || std::ranges::any_of(filter.ranges, [](const ValueRange& range) {
    return needs_fit_table(range.column);
  });
}

const ValueRange* find_range(const ShapeFilter& filter, const ShapeColumn& column) {
  const auto found = std::ranges::find(filter.ranges, column, &ValueRange::column);
  return found == filter.ranges.end() ? nullptr : &*found;
}

void set_range(ShapeFilter& filter, const ShapeColumn& column, double low, double high) {
  const ValueRange range{column, std::min(low, high), std::max(low, high)};
  const auto found = std::ranges::find(filter.ranges, column, &ValueRange::column);
  if (found == filter.ranges.end())
    filter.ranges.push_back(range);
  else
    *found = range;
}

void clear_range(ShapeFilter& filter, const ShapeColumn& column) {
  std::erase_if(filter.ranges, [&](const ValueRange& range) { return range.column == column; });
}

std::vector<std::size_t> shown_rows(const ShapeTable& shapes, const ShapeFilter& filter,
                                    const ShapeOrder& order) {
  std::vector<std::size_t> shown;
  const std::vector<std::string> wanted = words(filter.name);
  for (std::size_t i = 0; i < shapes.rows().size(); ++i)
    if (passes(shapes.rows()[i], filter, wanted) && has_parts(shapes, i, filter.parts)) shown.push_back(i);
  for (const ValueRange& range : filter.ranges) {
    const std::vector<double> values = column_values(shapes, range.column);
    std::erase_if(shown,
                  [&](std::size_t row) { return !(values[row] >= range.low && values[row] <= range.high); });
  }
  sort_rows(shown, shapes, order);
  return shown;
}

}  // namespace archetype
