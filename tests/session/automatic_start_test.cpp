// The choice of a start is the same however often it is stopped.
#include "core/session/automatic_start.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <mutex>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "core/base/error.h"
#include "core/io/template_file.h"
#include "core/session/learn_templates.h"
#include "core/session/suggest_templates.h"
#include "tests/support/imported_chairs.h"

using namespace archetype;
using namespace archetype::test;

namespace {

struct Chairs : ImportedChairs {
  Chairs() : ImportedChairs(4, 60) {}
  std::optional<PartTemplate> choose(const JobControl& control = {}, bool fresh = false) {
    return automatic_start(project, {}, {}, 1, fresh, 2, control);
  }
};

}  // namespace

TEST_CASE("a choice that was stopped goes on with the suggestions that it had, to the same one") {
  Chairs whole;
  const auto expected = whole.choose();
  REQUIRE(expected);
  Chairs stopped;
  std::stop_source source;
  const JobControl in_the_second_trial{source.get_token(),
                                       [&](std::size_t, std::size_t, std::string_view what) {
                                         if (what.starts_with("trying suggestion 2 of"))
                                           source.request_stop();
                                       }};
  CHECK_FALSE(stopped.choose(in_the_second_trial));
  CHECK(stopped.project.templates(false).empty());

  std::set<std::string> stages;
  std::mutex mutex;
  const JobControl watched{{}, [&](std::size_t, std::size_t, std::string_view what) {
                             const std::lock_guard lock(mutex);
                             stages.emplace(what);
                           }};
  CHECK(stopped.choose(watched) == expected);
  // Nothing is segmented or scored again, nor the first one tried.
  CHECK(std::ranges::all_of(stages, [](const std::string& stage) {
    return stage.starts_with("trying suggestion") && !stage.starts_with("trying suggestion 1 of");
  }));
  CHECK_FALSE(stages.empty());
  CHECK(learning_start(stopped.project) == std::vector{*expected});
  CHECK(stopped.project.templates(false).size() == whole.project.templates(false).size());
  CHECK(whole.project.templates(false).size() > 1);

  // Once it is made it is not made again, and what was learned since stays current.
  const std::vector<TemplateRecord> all = stopped.project.templates(false);
  const auto other =
      std::ranges::find_if(all, [&](const TemplateRecord& each) { return each.part_template != *expected; });
  REQUIRE(other != all.end());
  stopped.project.set_current_templates({other->id});
  stages.clear();
  CHECK(stopped.choose(watched) == expected);
  CHECK(stages.empty());
  CHECK(learning_start(stopped.project) == std::vector{other->part_template});
  CHECK(stopped.choose(watched, true) == expected);
  CHECK_FALSE(stages.empty());
  CHECK(learning_start(stopped.project) == std::vector{*expected});
}

TEST_CASE(
    "a choice that was not made yet is, where the project has its suggestions but another one is current") {
  Chairs whole;
  const auto expected = whole.choose();
  REQUIRE(expected);
  std::vector<PartTemplate> suggested;
  std::size_t other = 0;
  for (const TemplateRecord& each : whole.project.templates(false)) {
    if (each.part_template != *expected) other = suggested.size();
    suggested.push_back(each.part_template);
  }
  Chairs chairs;
  store_suggestions(chairs.project, suggested, other);
  REQUIRE(learning_start(chairs.project) != std::vector{*expected});
  CHECK(chairs.choose() == expected);
  CHECK(learning_start(chairs.project) == std::vector{*expected});
}

TEST_CASE("what another program left as the state of the choice is not gone on from") {
  Chairs chairs;
  const auto expected = chairs.choose();
  chairs.project.set_setting(std::string(start_state_setting), R"({"request":1})");
  CHECK(chairs.choose() == expected);
  const std::string request = learn_request(chairs.project, {}, {}, {}, 1).to_hex();
  PartTemplate stale = *expected;
  stale.name = "stale";
  const nlohmann::json before_scores{
      {"request", request}, {"energies", {0}}, {"candidates", {format_template(stale)}}};
  chairs.project.set_setting(std::string(start_state_setting), before_scores.dump());
  CHECK(chairs.choose() == expected);
}

TEST_CASE("a start cannot be chosen without shapes") {
  Project empty = Project::in_memory();
  CHECK_THROWS_AS(automatic_start(empty, {}, {}, 1, false, 1, {}), PreconditionError);
}
