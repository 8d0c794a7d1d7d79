// A project in memory with a few generated chairs, for tests of what is done with a collection.
#pragma once

#include "core/io/project.h"
#include "core/session/import_shapes.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/small_collection.h"

namespace archetype::test {

struct ImportedChairs {
  ScratchFolder folder;
  Project project = Project::in_memory();

  explicit ImportedChairs(std::size_t count, int points = 150) {
    write_chairs(folder.path(), count);
    ImportOptions options;
    options.points = points;
    import(options);
  }
  void import(const ImportOptions& options) {
    import_shapes(project, {folder.path() / "shapes"}, options, {});
  }
};

}  // namespace archetype::test
