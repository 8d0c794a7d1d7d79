// The templates that a project has in use.
#pragma once

#include <vector>

#include "core/io/project.h"

namespace archetype {

struct CurrentTemplates {
  std::vector<PartTemplate> templates;
  std::vector<TemplateId> ids;  // one per template
};

// In their order. Throws FileError.
CurrentTemplates current_templates(const Project& project);

}  // namespace archetype
