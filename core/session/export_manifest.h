// manifest.json of an export: what made it, from what, and what is not in it.
#pragma once

#include <string>

#include "core/session/export_project.h"

namespace archetype {

std::string export_manifest(const Project& project, const ExportOptions& options, const ExportReport& report);

}  // namespace archetype
