// archetype import PROJECT PATH…
#include <nlohmann/json.hpp>

#include <cstdio>
#include <iostream>

#include "app/batch/import_options.h"
#include "app/batch/json_output.h"
#include "app/batch/progress.h"

namespace archetype {

namespace {

struct Arguments {
  std::filesystem::path project;
  std::vector<std::filesystem::path> paths;
  ImportArguments import;
};

int run_import(const Arguments& arguments, const Invocation& invocation) {
  Project project = Project::open_or_create(arguments.project);
  ImportReport report;
  {
    Progress progress;
    report = import_shapes(project, arguments.paths, import_options(arguments.import, invocation),
                           progress.control(invocation.stop));
  }
  if (invocation.json) {
    print_json({{"imported", report.imported},
                {"unchanged", report.unchanged},
                {"shapes", project.shape_count()},
                {"refused", refused_json(report.refused)},
                {"warnings", report.warnings},
                {"cancelled", report.cancelled}});
  } else {
    print_import(report);
  }
  if (report.cancelled) return exit_code::stopped;
  return report.refused.empty() ? exit_code::done : exit_code::some_refused;
}

}  // namespace

void add_import_options(CLI::App& command, ImportArguments& arguments) {
  command
      .add_option("--up", arguments.up,
                  "Axis of the files that points up; auto decides over the whole collection")
      ->check(CLI::IsMember({"y", "z", "x", "-y", "-z", "-x", "auto"}))
      ->capture_default_str();
  command.add_option("--points", arguments.points, "Samples per shape")
      ->check(CLI::Range(50, 100'000))
      ->capture_default_str();
  command.add_option("--scale-by", arguments.scale_by, "What is 1 in every shape")
      ->check(CLI::IsMember({"mean-distance"}))
      ->capture_default_str();
}

ImportOptions import_options(const ImportArguments& arguments, const Invocation& invocation) {
  return {parse_up_axis(arguments.up), arguments.points, invocation.seed, invocation.threads};
}

void print_import(const ImportReport& report) {
  for (const std::string& warning : report.warnings) std::fprintf(stderr, "warning: %s\n", warning.c_str());
  print_refused(report.refused);
  std::cout << "imported " << report.imported << ", unchanged " << report.unchanged << ", refused "
            << report.refused.size()
            << (report.cancelled ? ", stopped: the same command goes on from here" : "") << std::endl;
}

void add_import_command(CLI::App& app, Invocation& invocation) {
  CLI::App* command =
      app.add_subcommand("import", "Read shapes into a project, which is made if there is none");
  const auto arguments = std::make_shared<Arguments>();
  command->add_option("PROJECT", arguments->project, "Project file")->required();
  command->add_option("PATH", arguments->paths, "Shape files, or folders to search for them")->required();
  add_import_options(*command, arguments->import);
  add_common_options(*command, invocation);
  add_json_option(*command, invocation);
  command->callback([&invocation, arguments] {
    invocation.run = [&invocation, arguments] { return run_import(*arguments, invocation); };
  });
}

}  // namespace archetype
