// Writes what was found out about a collection to a folder of plain files.
#pragma once

#include <cstdint>
#include <filesystem>

#include "core/base/job_control.h"
#include "core/io/project.h"

namespace archetype {

struct ExportOptions {
  bool labels = true;
  bool templates = true;  // with parts.csv
  bool fits = true;
  bool coaligned = true;
  bool boxes = true;
  std::uint64_t seed = 1;  // for the record only
  unsigned threads = 0;    // 0: all
};

struct ExportReport {
  std::size_t shapes = 0;          // fitted ones, which all files are about
  std::size_t without_fit = 0;     // have no row and no file
  std::size_t without_labels = 0;  // have no label file
  bool cancelled = false;
};

// The files are described in the README. Nothing is written outside `folder`, whatever shapes and templates
// are called; files that are there are replaced one by one, others stay. manifest.json comes last: a folder
// without it was not finished. Throws FileError if something cannot be written.
ExportReport export_project(const Project& project, const std::filesystem::path& folder,
                            const ExportOptions& options, const JobControl& control);

}  // namespace archetype
