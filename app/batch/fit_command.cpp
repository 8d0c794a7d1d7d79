// archetype fit PROJECT [--template FILE]… [PATH…]
#include <iostream>

#include "app/batch/import_options.h"
#include "app/batch/json_output.h"
#include "app/batch/progress.h"
#include "core/base/error.h"
#include "core/io/template_file.h"
#include "core/session/current_templates.h"
#include "core/session/fit_collection.h"

namespace archetype {

namespace {

struct Arguments {
  std::filesystem::path project;
  std::vector<std::filesystem::path> templates;
  std::vector<std::filesystem::path> paths;
  ImportArguments import;
};

// Those of the files or, without any, the current ones of the project.
std::vector<PartTemplate> chosen_templates(const std::vector<std::filesystem::path>& files,
                                           const Project& project) {
  std::vector<PartTemplate> templates;
  templates.reserve(files.size());
  for (const std::filesystem::path& file : files) templates.push_back(read_template(file));
  if (files.empty()) templates = current_templates(project).templates;
  if (templates.empty())
    throw FileError(project.path(), "has no template yet; give one with --template FILE");
  return templates;
}

int run_fit(const Arguments& arguments, const Invocation& invocation) {
  // The templates first: a mistake in one should not wait for a long import.
  std::vector<PartTemplate> templates;
  if (!arguments.templates.empty()) templates = chosen_templates(arguments.templates, Project::in_memory());
  Project project =
      arguments.paths.empty() ? Project::open(arguments.project) : Project::open_or_create(arguments.project);
  if (templates.empty()) templates = chosen_templates({}, project);
  ImportReport imported;
  FitCollectionReport fitted;
  {
    Progress progress;
    const JobControl control = progress.control(invocation.stop);
    if (!arguments.paths.empty()) {
      imported =
          import_shapes(project, arguments.paths, import_options(arguments.import, invocation), control);
    }
    if (imported.cancelled) {
      fitted.cancelled = true;
    } else {
      fitted = fit_collection(project, templates, {}, invocation.threads, control);
    }
  }
  if (invocation.json) {
    print_json({{"imported", imported.imported},
                {"unchanged", imported.unchanged},
                {"fitted", fitted.fitted},
                {"kept", fitted.kept},
                {"refused", refused_json(imported.refused)},
                {"not_fitted_or_labelled", refused_json(fitted.refused)},
                {"warnings", imported.warnings},
                {"cancelled", fitted.cancelled}});
  } else {
    if (!arguments.paths.empty()) print_import(imported);
    print_refused(fitted.refused);
    std::cout << "fitted " << fitted.fitted << ", kept " << fitted.kept << ", refused "
              << fitted.refused.size()
              << (fitted.cancelled ? ", stopped: the same command goes on from here" : "") << std::endl;
  }
  if (fitted.cancelled) return exit_code::stopped;
  return imported.refused.empty() && fitted.refused.empty() ? exit_code::done : exit_code::some_refused;
}

}  // namespace

void add_fit_command(CLI::App& app, Invocation& invocation) {
  CLI::App* command =
      app.add_subcommand("fit", "Fit templates to the shapes of a project and label their faces");
  const auto arguments = std::make_shared<Arguments>();
  command->add_option("PROJECT", arguments->project, "Project file; made if PATHs are given")->required();
  command->add_option("PATH", arguments->paths, "Shape files or folders to import first");
  command
      ->add_option("--template", arguments->templates,
                   "Template file; may be repeated. Default: the project's")
      ->type_name("FILE")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->allow_extra_args(false);
  add_import_options(*command, arguments->import);
  add_common_options(*command, invocation);
  add_json_option(*command, invocation);
  command->callback([&invocation, arguments] {
    invocation.run = [&invocation, arguments] { return run_fit(*arguments, invocation); };
  });
}

}  // namespace archetype
