// Which files an import is about, and what each is called.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/job_control.h"
#include "core/io/project.h"

namespace archetype {

struct ShapeInput {
  std::string name;            // as in ShapeRecord
  std::filesystem::path path;  // absolute, "." and ".." taken out
};

struct ShapeScan {
  std::vector<ShapeInput> inputs;     // ordered by name, then path; a file only once, names may repeat
  std::vector<RefusedInput> refused;  // folders that cannot be read, arguments that are no shape
};

// Folders are searched recursively, links to folders followed (a loop ends where it comes back). In a folder,
// hidden files and files that have no ending of a shape are passed over; as arguments they are refused with
// the reason. The order of `paths` does not matter. A file that is reached under two names keeps the longer
// one.
ShapeScan scan_shapes(const std::vector<std::filesystem::path>& paths, const JobControl& control);

}  // namespace archetype
