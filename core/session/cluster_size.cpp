#include "core/session/cluster_size.h"

namespace archetype {
namespace {

std::string counted(std::size_t count, const char* thing) {
  std::string digits = std::to_string(count);
  for (auto at = static_cast<std::ptrdiff_t>(digits.size()) - 3; at > 0; at -= 3)
    digits.insert(static_cast<std::size_t>(at), 1, ',');
  return digits + ' ' + thing + (count == 1 ? "" : "s");
}

}  // namespace

std::string to_string(const ClusterSize& size) {
  std::string text = counted(size.shapes, "shape");
  return size.outliers == 0 ? text : text + ", " + counted(size.outliers, "outlier");
}

}  // namespace archetype
