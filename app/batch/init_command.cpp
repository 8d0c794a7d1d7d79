// archetype init PROJECT [--shapes K] [--parts MIN:MAX] [--candidates 10]
#include <charconv>
#include <iostream>
#include <utility>

#include "app/batch/command.h"
#include "app/batch/json_output.h"
#include "app/batch/progress.h"
#include "app/batch/table.h"
#include "core/base/error.h"
#include "core/session/suggest_templates.h"

namespace archetype {

namespace {

constexpr int most_parts = 64;

struct Arguments {
  std::filesystem::path project;
  std::string parts = "2:12";
  SuggestOptions options;
};

// MIN:MAX, or one number for both; nothing for any other text.
std::optional<std::pair<int, int>> parse_range(const std::string& text) {
  int low = 0;
  const char* end = text.data() + text.size();
  auto [rest, error] = std::from_chars(text.data(), end, low);
  if (error != std::errc{}) return std::nullopt;
  int high = low;
  if (rest != end) {
    if (*rest != ':') return std::nullopt;
    const auto second = std::from_chars(rest + 1, end, high);
    if (second.ec != std::errc{} || second.ptr != end) return std::nullopt;
  }
  if (low < 1 || high < low || high > most_parts) return std::nullopt;
  return std::pair{low, high};
}

void print_suggestions(const Suggestions& suggestions, const Invocation& invocation) {
  if (invocation.json) {
    auto list = nlohmann::ordered_json::array();
    for (const InitialTemplate& suggestion : suggestions.templates) {
      list.push_back({{"name", suggestion.part_template.name},
                      {"parts", suggestion.part_template.parts.size()},
                      {"mean_energy", suggestion.mean_energy},
                      {"score", suggestion.score}});
    }
    print_json({{"segmented", suggestions.segmented},
                {"scored", suggestions.scored},
                {"templates", list},
                {"cancelled", suggestions.cancelled}});
    return;
  }
  if (suggestions.cancelled) {
    std::cout << "stopped: the project is as it was" << std::endl;
    return;
  }
  std::vector<std::vector<std::string>> rows{{"template", "rank", "parts", "mean energy", "score"}};
  for (const InitialTemplate& suggestion : suggestions.templates) {
    rows.push_back({suggestion.part_template.name, std::to_string(rows.size()),
                    std::to_string(suggestion.part_template.parts.size()), fixed(suggestion.mean_energy, 4),
                    fixed(suggestion.score, 4)});
  }
  print_table(std::cout, rows);
}

int run_init(Arguments& arguments, const Invocation& invocation) {
  Project project = Project::open(arguments.project);
  if (project.shape_count() == 0)
    throw FileError(arguments.project, "has no shape yet; add some with `archetype import`");
  SuggestOptions& options = arguments.options;
  const auto range = parse_range(arguments.parts).value();
  options.initial.segmentation.min_parts = range.first;
  options.initial.segmentation.max_parts = range.second;
  options.seed = invocation.seed;
  Suggestions suggestions;
  {
    Progress progress;
    suggestions = suggest_templates(project, options, invocation.threads, progress.control(invocation.stop));
  }
  if (!suggestions.templates.empty()) {
    std::vector<PartTemplate> templates;
    for (const InitialTemplate& each : suggestions.templates) templates.push_back(each.part_template);
    store_suggestions(project, templates, 0);
  }
  print_suggestions(suggestions, invocation);
  return suggestions.cancelled ? exit_code::stopped : exit_code::done;
}

}  // namespace

void add_init_command(CLI::App& app, Invocation& invocation) {
  CLI::App* command = app.add_subcommand("init", "Make initial templates from segmentations of some shapes");
  const auto arguments = std::make_shared<Arguments>();
  command->add_option("PROJECT", arguments->project, "Project file")->required();
  command->add_option("--shapes", arguments->options.segmented_shapes, "Shapes to segment")
      ->type_name("K")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command->add_option("--parts", arguments->parts, "Parts of a shape, at least and at most")
      ->type_name("MIN:MAX")
      ->check([](const std::string& text) {
        return parse_range(text) ? std::string()
                                 : text + " is no range of parts; write MIN:MAX, as 3:12, up to 64";
      })
      ->capture_default_str();
  command
      ->add_option("--candidates", arguments->options.initial.candidates,
                   "Templates to keep; the best becomes the project's template")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  add_common_options(*command, invocation);
  add_json_option(*command, invocation);
  command->callback([&invocation, arguments] {
    invocation.run = [&invocation, arguments] { return run_init(*arguments, invocation); };
  });
}

}  // namespace archetype
