// What the files of an export look like, one function each; see the README for their columns.
#pragma once

#include <set>
#include <span>
#include <string>

#include "core/io/project.h"

namespace archetype {

// A name that can stand as a file name before an ending: no separators or control characters, at most 200
// bytes. A name that had to be changed ends in digits of its hash, so that different names stay different.
std::string export_file_name(const std::string& name);

// The same, made different from all that are in `taken` by "-2", "-3", …; and put there.
std::string unique_export_name(const std::string& name, std::set<std::string>& taken);

std::string fits_header();
// yaw_degrees is how the shape of the file stands to its template, about the axis of the file that points up.
std::string fits_row(const std::string& name, const ShapeRecord& shape, const std::string& part_template,
                     const FitRecord& fit);

std::string parts_header();
std::string parts_rows(const std::string& template_name, const PartTemplate& part_template);

// Boxes in the file coordinates of the shape, also of parts that are absent (their mean boxes), and which
// solid of the same volume a part is instead.
std::string boxes_header();
std::string boxes_rows(const std::string& shape, const ShapeFrame& frame, const ShapeFit& fit);

// Binary little-endian PLY: x y z in file coordinates, cx cy cz in the canonical space, part (-1: none),
// face, red green blue of the part of the template. `canonical` has one entry per sample.
std::string coaligned_ply(const PartTemplate& part_template, const ShapeSamples& samples,
                          std::span<const Vec3> canonical, const ShapeFit& fit);

}  // namespace archetype
