#include "core/report/axis_marks.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace archetype {

std::vector<double> axis_marks(double low, double high, std::size_t most) {
  if (!(high - low > 1e-12 * std::max(std::abs(low), std::abs(high)))) {
    const double room = std::max(std::abs(low) * 0.05, 1e-3);
    low -= room;
    high += room;
  }
  double step = std::pow(10, std::floor(std::log10(high - low)) - 1);
  const auto count = [&] { return std::ceil(high / step - 1e-9) - std::floor(low / step + 1e-9) + 1; };
  for (int i = 0; count() > static_cast<double>(most); ++i) step *= i % 3 == 1 ? 2.5 : 2;  // 1, 2, 5, 10
  std::vector<double> marks;
  const double first = std::floor(low / step + 1e-9);
  const auto marked = static_cast<int>(std::lround(count()));
  for (int i = 0; i < marked; ++i) marks.push_back((first + i) * step);
  return marks;
}

std::string mark_text(double value, double step) {
  char text[32];
  if (std::abs(value) < step * 1e-6) value = 0;  // not -0, not 1e-17
  if (std::abs(value) >= 1e7 || step < 1e-6) {
    std::snprintf(text, sizeof text, "%.3g", value);
  } else {
    const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 6);
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
  }
  return text;
}

}  // namespace archetype
