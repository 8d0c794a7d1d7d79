// A project as one page for a browser: to look at, hand on and keep.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "core/base/job_control.h"
#include "core/io/project.h"

namespace archetype {

// A picture of a fitted shape; an empty one where none can be drawn. Throws nothing.
using DrawShape = std::function<Picture(ShapeId)>;

struct ReportOptions {
  std::string title;             // of the page; "": the name of the project's file
  std::filesystem::path labels;  // of ground truth, for the accuracy; empty: none
  unsigned threads = 0;          // 0: all
  DrawShape draw = {};           // shapes that the project keeps no thumbnail of; else by their samples
};

struct HtmlReport {
  std::string page;
  std::size_t shapes = 0;
  std::size_t pictures = 0;
};

// The page is whole: pictures lie inside of it, nothing is loaded and no script is needed. It shows the
// collection, the templates, the clusters with their best members, the worst fits, the accuracy, learning,
// settings and what was refused; long lists are cut, and say so. The same project gives the same bytes.
// Pictures are the thumbnails that the window has kept, and drawn where there is none; about 20 KB each, at
// most some hundred. Nothing if cancelled. Throws FileError.
std::optional<HtmlReport> html_report(const Project& project, const ReportOptions& options,
                                      const JobControl& control);

}  // namespace archetype
