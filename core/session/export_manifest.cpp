// Gathers the manifest. It holds no times and no names of machines, so that the same work gives the same
// bytes.
#include "core/session/export_manifest.h"

#include <map>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/io/json_input.h"
#include "core/session/fit_state.h"

namespace archetype {

namespace {

using Json = nlohmann::ordered_json;

Json exported_json(const ExportOptions& options) {
  Json list = Json::array();
  if (options.labels) list.push_back("labels");
  if (options.templates) list.push_back("templates");
  if (options.fits) list.push_back("fits");
  if (options.coaligned) list.push_back("coaligned");
  if (options.boxes) list.push_back("boxes");
  return list;
}

// How the shapes were sampled: one entry for each way, most often one.
Json sampling_json(const Project& project) {
  using Way = std::tuple<int, std::uint64_t, std::string, bool>;
  std::map<Way, std::size_t> ways;
  for (const ShapeRecord& shape : project.shapes()) {
    ++ways[{shape.requested_points, shape.seed, std::string(to_string(shape.up)), shape.up_decided}];
  }
  Json list = Json::array();
  for (const auto& [way, shapes] : ways) {
    const auto& [points, seed, up, decided] = way;
    list.push_back(
        {{"points", points}, {"seed", seed}, {"up", up}, {"up_decided", decided}, {"shapes", shapes}});
  }
  return list;
}

// The seed that the shapes were sampled with, or most of them: all that is drawn at random is drawn then. One
// of an empty project is that of the export.
std::uint64_t seed_of_samples(const Project& project, std::uint64_t otherwise) {
  std::map<std::uint64_t, std::size_t> shapes;
  for (const ShapeRecord& shape : project.shapes()) ++shapes[shape.seed];
  const auto most = std::ranges::max_element(shapes, {}, [](const auto& entry) { return entry.second; });
  return most == shapes.end() ? otherwise : most->first;
}

// Null where a project from elsewhere holds something that is no JSON.
Json fit_options_json(const Project& project) {
  const std::optional<std::string> text = project.setting(fit_options_setting);
  if (!text) return {};
  try {
    return parse_json(*text, project.path());
  } catch (const InputError&) {
    return {};
  }
}

}  // namespace

std::string export_manifest(const Project& project, const ExportOptions& options,
                            const ExportReport& report) {
  Json refused = Json::array();
  for (const RefusedInput& input : project.refused()) {
    refused.push_back({{"path", input.path.string()}, {"reason", input.reason}});
  }
  const Json manifest{{"format", "archetype-export"},
                      {"version", 1},
                      {"program", "archetype " ARCHETYPE_VERSION},
                      {"seed", seed_of_samples(project, options.seed)},
                      {"options",
                       {{"exported", exported_json(options)},
                        {"sampling", sampling_json(project)},
                        {"fit", fit_options_json(project)}}},
                      {"counts",
                       {{"shapes", project.shape_count()},
                        {"fitted", report.shapes},
                        {"not_fitted", report.without_fit},
                        {"not_labelled", report.without_labels},
                        {"templates", project.templates().size()},
                        {"refused", refused.size()}}},
                      {"refused", refused}};
  return manifest.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace archetype
