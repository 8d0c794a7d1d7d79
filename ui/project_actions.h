// What is done with whole projects: opened, imported into, fitted, saved elsewhere. All of it runs as jobs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/session/import_shapes.h"
#include "core/session/session_mark.h"

namespace archetype {

struct Studio;

// Opens whatever the path is: a folder of shapes, a project, a template, or a shape that is added to the
// collection. Throws Error if it is none of these.
void open_path(Studio& studio, const std::filesystem::path& path);

// An untitled project that belongs to the folder; what was imported from it before is there at once, and what
// is new is read beside.
void open_folder(Studio& studio, const std::filesystem::path& folder);
void open_project(Studio& studio, const std::filesystem::path& path);
// The project that an earlier session had open.
void reopen_project(Studio& studio, const SessionRecord& record);
void add_shapes(Studio& studio, const std::vector<std::filesystem::path>& paths);

// Whether a job writes shapes or fits to the project, and whether it is one that fits.
bool is_written(const Studio& studio, const std::filesystem::path& project);
bool is_fitted(const Studio& studio, const std::filesystem::path& project);

// Copies the project, or makes one of the templates while none is open; the copy is the one that is worked on
// from then on, unless another project has come into view meanwhile or a job writes to the one that was
// copied.
void save_project_as(Studio& studio, const std::filesystem::path& path);

// The active template on every shape; results come into the grid as they are made.
void fit_all(Studio& studio);

// What was open last, if it is still there and can be read, else the seats; a message says why.
void open_last(Studio& studio);

// Extracts the seats of Sweet Home 3D from Debian's package once, then opens them. A message says what to
// install where the package is missing.
void open_seats(Studio& studio);
// Makes a collection with ground truth among the program's own files and opens it.
void open_generated(Studio& studio, const std::string& family, std::size_t count);

// The names of the templates that come with the program, and the file of one; empty if there is none.
std::vector<std::string> starting_templates(const Studio& studio);
std::filesystem::path starting_template_path(const Studio& studio, const std::string& name);

// Throws Error where the file cannot be read or written.
void load_template(Studio& studio, const std::filesystem::path& path);
void save_template(Studio& studio, const std::filesystem::path& path);

}  // namespace archetype
