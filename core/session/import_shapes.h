// Import of files and folders into a project.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "core/base/job_control.h"
#include "core/io/project.h"

namespace archetype {

struct ImportOptions {
  std::optional<UpAxis> up = UpAxis::y;  // nothing: decided over the whole collection (`auto`)
  int points = 1000;                     // samples per shape
  std::uint64_t seed = 1;
  unsigned threads = 0;  // 0: all
};

struct ImportReport {
  std::size_t imported = 0;   // read now
  std::size_t unchanged = 0;  // were there already, with the same content and options
  std::vector<RefusedInput> refused;
  std::vector<std::string> warnings;  // one line each, with the file
  bool cancelled = false;
};

// Folders are searched recursively; files are read in parallel and committed in batches, so that a cancelled
// or killed import keeps what is done and the same call goes on from there. Files that fail are listed and
// the rest imported.
ImportReport import_shapes(Project& project, const std::vector<std::filesystem::path>& paths,
                           const ImportOptions& options, const JobControl& control);

}  // namespace archetype
