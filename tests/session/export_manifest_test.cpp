// The manifest of an export is JSON, whatever the project holds.
#include "core/session/export_manifest.h"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "core/session/fit_state.h"

using namespace archetype;

TEST_CASE("Fit options that are none are null in the manifest") {
  Project project = Project::in_memory();
  const auto fit_options = [&] {
    return nlohmann::json::parse(export_manifest(project, {}, {})).at("options").at("fit");
  };
  CHECK(fit_options().is_null());
  project.set_setting(fit_options_setting, R"({"alpha": 2})");
  CHECK(fit_options().at("alpha") == 2);
  for (const std::string& text : {std::string("{\"alpha\""), std::string(200'000, '[')}) {
    project.set_setting(fit_options_setting, text);
    CHECK(fit_options().is_null());
  }
}
