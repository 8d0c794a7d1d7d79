// Writes JSON that is valid whatever the names of files are.
#include "app/batch/json_output.h"

#include <iostream>

namespace archetype {

void print_json(const nlohmann::ordered_json& json) {
  std::cout << json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
}

nlohmann::ordered_json refused_json(const std::vector<RefusedInput>& refused) {
  auto list = nlohmann::ordered_json::array();
  for (const RefusedInput& input : refused) {
    list.push_back({{"path", input.path.string()}, {"reason", input.reason}});
  }
  return list;
}

}  // namespace archetype
