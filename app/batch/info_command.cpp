// archetype info PROJECT
#include <iostream>

#include "app/batch/command.h"
#include "app/batch/json_output.h"
#include "app/batch/table.h"

namespace archetype {

namespace {

using Json = nlohmann::ordered_json;

int run_info(const std::filesystem::path& path, const Invocation& invocation) {
  const Project project = Project::open(path);
  const std::vector<FitSummary> fits = project.fits();
  std::size_t labelled = 0;
  double energy = 0;
  std::map<TemplateId, std::size_t> members;
  for (const FitSummary& fit : fits) {
    labelled += fit.has_labels ? 1 : 0;
    energy += fit.energy.total() / static_cast<double>(fits.size());
    ++members[fit.part_template];
  }
  const std::vector<TemplateRecord> templates = project.templates();
  const std::vector<RefusedInput> refused = project.refused();
  const std::size_t corrected = project.corrections().size();
  if (invocation.json) {
    Json list = Json::array();
    for (const TemplateRecord& record : templates) {
      list.push_back({{"name", record.part_template.name},
                      {"parts", record.part_template.parts.size()},
                      {"iteration", record.iteration},
                      {"shapes", members[record.id]}});
    }
    print_json({{"project", project.path().string()},
                {"shapes", project.shape_count()},
                {"fitted", fits.size()},
                {"labelled", labelled},
                {"corrected", corrected},
                {"mean_energy", energy},
                {"templates", list},
                {"refused", refused_json(refused)}});
    return exit_code::done;
  }
  std::vector<std::vector<std::string>> rows{{"shapes", std::to_string(project.shape_count())},
                                             {"fitted", std::to_string(fits.size())},
                                             {"labelled", std::to_string(labelled)},
                                             {"corrected by hand", std::to_string(corrected)},
                                             {"refused inputs", std::to_string(refused.size())},
                                             {"mean energy", fits.empty() ? "-" : fixed(energy, 4)}};
  print_table(std::cout, rows);
  if (!templates.empty()) {
    std::cout << '\n';
    rows = {{"template", "parts", "shapes"}};
    for (const TemplateRecord& record : templates) {
      rows.push_back({record.part_template.name, std::to_string(record.part_template.parts.size()),
                      std::to_string(members[record.id])});
    }
    print_table(std::cout, rows);
  }
  for (const RefusedInput& input : refused) {
    std::cout << "\nrefused: " << input.path.string() << ": " << input.reason;
  }
  if (!refused.empty()) std::cout << '\n';
  return exit_code::done;
}

}  // namespace

void add_info_command(CLI::App& app, Invocation& invocation) {
  CLI::App* command = app.add_subcommand("info", "Say what is in a project");
  const auto path = std::make_shared<std::filesystem::path>();
  command->add_option("PROJECT", *path, "Project file")->required();
  add_common_options(*command, invocation);
  add_json_option(*command, invocation);
  command->callback(
      [&invocation, path] { invocation.run = [&invocation, path] { return run_info(*path, invocation); }; });
}

}  // namespace archetype
