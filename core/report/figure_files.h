// Figures as files: SVG to print, CSV to go on with.
#pragma once

#include <filesystem>
#include <string>

#include "core/report/plot.h"

namespace archetype {

// In pixels. A figure that would be unreadable so gets higher.
struct SvgOptions {
  float width = 900;
  float height = 560;
};

// A whole SVG 1.1 document on white. Values are told where the mouse rests, by title elements.
std::string to_svg(const Figure& figure, const SvgOptions& options = {});

// A line per value: plot,series,x,y,note, quoted as RFC 4180 says. x is the name where bars stand beside
// names; of a matrix, series is the row and x the column. Shares are from 0 to 1. What is not finite is left
// out.
std::string to_csv(const Figure& figure);

// By the ending, .svg or .csv. Throws InputError for another one, FileError where it cannot be written.
void write_figure(const std::filesystem::path& path, const Figure& figure);

}  // namespace archetype
