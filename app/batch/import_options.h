// The options of an import, which `import` and `fit` take.
#pragma once

#include <string>

#include "app/batch/command.h"
#include "core/session/import_shapes.h"

namespace archetype {

struct ImportArguments {
  std::string up = "y";
  int points = 1000;
  std::string scale_by = "mean-distance";
};

void add_import_options(CLI::App& command, ImportArguments& arguments);
ImportOptions import_options(const ImportArguments& arguments, const Invocation& invocation);

// What an import did, as a line of text on standard output, with its warnings and refusals on standard error.
void print_import(const ImportReport& report);

}  // namespace archetype
