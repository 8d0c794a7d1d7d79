#include "core/model/part_names.h"

#include <algorithm>

namespace archetype {

std::string common_part_name(std::span<const std::string> names) {
  if (names.empty()) return "";
  std::size_t common = names.front().size();
  for (const std::string& name : names) {
    const auto end =
        std::mismatch(name.begin(), name.end(), names.front().begin(), names.front().end()).first;
    std::size_t same = static_cast<std::size_t>(end - name.begin());
    const bool whole = (same == name.size() || name[same] == ' ') &&
                       (same == names.front().size() || names.front()[same] == ' ');
    if (!whole) same = name.rfind(' ', same == 0 ? 0 : same - 1);
    common = std::min(common, same == std::string::npos ? 0 : same);
  }
  return common == 0 ? names.front() : names.front().substr(0, common);
}

}  // namespace archetype
