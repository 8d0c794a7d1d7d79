#include "core/session/current_templates.h"

#include <utility>

namespace archetype {

CurrentTemplates current_templates(const Project& project) {
  CurrentTemplates current;
  for (TemplateRecord& each : project.templates()) {
    current.ids.push_back(each.id);
    current.templates.push_back(std::move(each.part_template));
  }
  return current;
}

}  // namespace archetype
