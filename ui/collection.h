// The open project as the window sees it: one row per shape, without samples and faces. The project file
// itself is only touched beside the window, by jobs and workers with connections of their own.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/job_control.h"
#include "core/io/project.h"
#include "core/session/document.h"
#include "core/session/ground_truth.h"
#include "core/session/latest_worker.h"
#include "core/session/learn_templates.h"
#include "core/session/measure_starts.h"
#include "core/session/measure_subsets.h"
#include "core/session/shape_row.h"

namespace archetype {

struct CollectionRows {
  std::vector<ShapeRow> rows;  // ordered by name
  std::vector<RefusedInput> refused;
  std::vector<PartTemplate> templates;             // the project's current ones
  std::shared_ptr<const LearningRecord> learning;  // null: nothing was learned yet
  bool learning_can_go_on = false;                 // with these shapes, and with the corrections below
  std::shared_ptr<const Corrections> corrections;  // as the project has them; null: none
  GroundTruthFolders truth;                        // where it is, as far as is known
  std::vector<SubsetMeasure> subsets;              // how learning grows, if it was measured
  // What came of several templates to begin with; null: not measured.
  std::shared_ptr<const std::vector<StartMeasure>> starts;
};

// The seed of all learning in the window; that of the batch program, where none is given.
inline constexpr std::uint64_t learning_seed = 1;

struct Collection {
  std::filesystem::path path;    // of the project file; empty: nothing is open
  std::string title;             // for people
  bool untitled = false;         // lies among the program's own files: "Save as" has not been used yet
  std::filesystem::path folder;  // of the shapes of an untitled one: opening it brings the project back
  CollectionRows content;
  std::uint64_t revision = 0;  // changes with the content

  bool open() const { return !path.empty(); }
  const std::vector<ShapeRow>& rows() const { return content.rows; }
};

// Where the untitled project of a folder is kept: the same folder, the same file.
std::filesystem::path untitled_project_path(const std::filesystem::path& data_folder,
                                            const std::filesystem::path& shapes_folder);

// About 30 ms for 10,000 shapes. Throws FileError.
CollectionRows read_rows(const Project& project);
// For a worker: nothing if the project cannot be read just now.
std::optional<CollectionRows> reread_rows(const std::filesystem::path& project, const JobControl& control);
using RowsReader = LatestWorker<std::filesystem::path, CollectionRows>;

// The document that was being edited, after the project's current templates where these have changed
// since it was stored by other means. Throws Error.
Document read_document(const Project& project);
// What fits and learning heed, as the document has it now: autosave may be behind.
void store_corrections(Project& project, const Document& document);
struct SaveDocument {
  std::filesystem::path project;
  Document document;
  bool alone = false;          // the file is no project, but holds the document and nothing else
  std::vector<ShapeId> strip;  // the shapes of the strip
};
// Those that are still in the project.
std::vector<ShapeId> read_strip(const Project& project);
// For a worker; the result is what went wrong, or "".
std::optional<std::string> save_document(const SaveDocument& request, const JobControl& control);
using DocumentSaver = LatestWorker<SaveDocument, std::string>;

std::optional<std::size_t> find_row(const Collection& collection, ShapeId id);

}  // namespace archetype
