// Whatever is being done, it ends within a second of being told to stop.
#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <ctime>
#include <functional>
#include <mutex>
#include <thread>

#include "core/base/random.h"
#include "core/generate/generate.h"
#include "core/io/template_file.h"
#include "core/session/automatic_start.h"
#include "core/session/evaluate_labelling.h"
#include "core/session/evaluate_landmarks.h"
#include "core/session/export_project.h"
#include "core/session/fit_collection.h"
#include "core/session/import_shapes.h"
#include "core/session/jobs.h"
#include "core/session/learn_templates.h"
#include "core/session/suggest_templates.h"
#include "tests/support/big_shape.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/small_collection.h"

using namespace archetype;
using namespace archetype::test;

namespace fs = std::filesystem;

namespace {

using Clock = std::chrono::steady_clock;
using Work = std::function<void(const JobControl&)>;

constexpr double longest = 1;  // seconds

struct Moment {
  Clock::time_point time = Clock::now();
  std::clock_t processor = std::clock();
};

// On a machine that others keep busy, what the processor did for this program in the meantime: there, too,
// only its own work counts.
double seconds_between(const Moment& from, const Moment& to) {
  return std::min(std::chrono::duration<double>(to.time - from.time).count(),
                  static_cast<double>(to.processor - from.processor) / CLOCKS_PER_SEC);
}

// How long the work goes on after its report number `report`, from 0, of a stage whose name begins with
// `stage`; nothing if it makes no such report.
std::optional<double> seconds_to_stop(const Work& work, std::string_view stage, std::size_t report) {
  std::stop_source source;
  std::mutex mutex;
  std::size_t reports = 0;
  Moment told;
  const JobControl control{source.get_token(), [&](std::size_t, std::size_t, std::string_view what) {
                             const std::lock_guard lock(mutex);
                             if (!what.starts_with(stage) || reports++ != report) return;
                             told = Moment();
                             source.request_stop();
                           }};
  work(control);
  if (!source.stop_requested()) return std::nullopt;
  return seconds_between(told, Moment());
}

// Stops the work at the first report of each stage and at some later one.
void check_stages(const Work& work, const std::vector<std::string_view>& stages, RandomStream& random) {
  for (const std::string_view stage : stages) {
    CAPTURE(stage);
    const std::optional<double> first = seconds_to_stop(work, stage, 0);
    REQUIRE(first);
    CHECK(*first < longest);
    const std::optional<double> later = seconds_to_stop(work, stage, 1 + random.below(5));
    CHECK(later.value_or(0) < longest);
  }
}

// How long the work goes on after it is told to stop when it has run for so long.
double seconds_to_stop_after(const Work& work, double seconds) {
  std::stop_source source;
  std::atomic<bool> over = false;
  Moment told;
  std::jthread watch([&] {
    const Clock::time_point start = Clock::now();
    while (!over && std::chrono::duration<double>(Clock::now() - start).count() < seconds)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    told = Moment();
    source.request_stop();
  });
  work({source.get_token(), {}});
  const Moment ended;
  over = true;
  watch.join();
  return seconds_between(told, ended);
}

// Stops the work at moments spread over the time that it takes undisturbed.
void check_moments(const Work& work, int moments, RandomStream& random) {
  const Clock::time_point start = Clock::now();
  work({});
  const double whole = std::chrono::duration<double>(Clock::now() - start).count();
  CAPTURE(whole);
  for (int i = 0; i < moments; ++i) {
    const double moment = whole * (i + random.uniform()) / moments;
    CAPTURE(moment);
    CHECK(seconds_to_stop_after(work, moment) < longest);
  }
}

ImportOptions sampled_with(int points) {
  ImportOptions options;
  options.points = points;
  options.threads = 2;
  return options;
}

// Many small chairs, in a project that is a file.
struct Collection {
  ScratchFolder folder;
  fs::path path = folder.path() / "p.archetype";
  int points;  // of each
  RandomStream random{7};

  Collection(std::size_t count, int points_of_each) : points(points_of_each) {
    write_chairs(folder.path(), count);
  }
  Project imported() const {
    Project project = Project::open_or_create(path);
    import_shapes(project, {folder.path() / "shapes"}, sampled_with(points), {});
    return project;
  }
};

LearnOptions few_shapes() {
  LearnOptions options;
  options.sample_size = 8;
  return options;
}

}  // namespace

TEST_CASE("an import stops within a second while it searches, reads, and finds what is up") {
  Collection chairs(60, 300);
  const Work import = [&](const JobControl& control) {
    Project project = Project::in_memory();
    ImportOptions options = sampled_with(chairs.points);
    options.up.reset();
    import_shapes(project, {chairs.folder.path() / "shapes"}, options, control);
  };
  check_stages(import, {"reading shapes", "looking which way is up"}, chairs.random);
  check_moments(import, 6, chairs.random);
}

TEST_CASE("init stops within a second while it loads, segments, scores and joins") {
  Collection chairs(5, 60);
  const Project project = chairs.imported();
  const Work init = [&](const JobControl& control) {
    SuggestOptions options;
    options.segmented_shapes = 3;
    suggest_templates(project, options, 2, control);
  };
  check_stages(init, {"loading", "segmenting", "scoring", "joining"}, chairs.random);
  check_moments(init, 3, chairs.random);
}

TEST_CASE("the choice of a start stops within a second") {
  Collection chairs(4, 60);
  Project project = chairs.imported();
  const Work choose = [&](const JobControl& control) {
    automatic_start(project, {}, few_shapes(), 1, false, 2, control);
  };
  // What was tried is kept, so that the second time other suggestions are being tried.
  check_stages(choose, {"segmenting", "scoring", "trying", "trying"}, chairs.random);
}

TEST_CASE("learning stops within a second in every round and while it labels") {
  Collection chairs(20, 150);
  Project project = chairs.imported();
  const Work learn = [&](const JobControl& control) {
    PartTemplate start = chair_template();
    for (TemplatePart& part : start.parts) part.scale.mean *= 1.3;
    learn_templates(project, {start}, {}, few_shapes(), 1, true, 2, control);
    project.clear_fits();
  };
  check_stages(learn, {"learning, round 1", "learning, round 2", "fitting"}, chairs.random);
  check_moments(learn, 4, chairs.random);
}

TEST_CASE("a fit, an evaluation and an export stop within a second") {
  Collection chairs(60, 300);
  Project project = chairs.imported();
  const Work fit = [&](const JobControl& control) {
    project.clear_fits();
    fit_collection(project, {chair_template()}, {}, 2, control);
  };
  check_stages(fit, {"fitting"}, chairs.random);
  fit({});
  const Work labels = [&](const JobControl& control) {
    evaluate_labelling(project, chairs.folder.path() / "labels", 2, control);
  };
  check_stages(labels, {"evaluating"}, chairs.random);
  const Work landmarks = [&](const JobControl& control) {
    evaluate_landmarks(project, chairs.folder.path() / "landmarks", 2, control);
  };
  check_stages(landmarks, {"locating landmarks", "comparing landmarks"}, chairs.random);
  const Work write = [&](const JobControl& control) {
    export_project(project, chairs.folder.path() / "out", {}, control);
  };
  check_stages(write, {"exporting"}, chairs.random);
}

TEST_CASE("a shape of 300,000 faces does not keep anything from stopping within a second") {
  const ScratchFolder folder;
  write_big_chair(folder.path(), 300'000);
  RandomStream random(11);
  const Work import = [&](const JobControl& control) {
    Project project = Project::in_memory();
    import_shapes(project, {folder.path() / "shapes"}, sampled_with(1000), control);
  };
  check_moments(import, 4, random);
  Project project = Project::in_memory();
  import_shapes(project, {folder.path() / "shapes"}, sampled_with(1000), {});
  const Work fit = [&](const JobControl& control) {
    project.clear_fits();
    fit_collection(project, {chair_template()}, {}, 2, control);
  };
  check_moments(fit, 8, random);
  fit({});
  check_moments(
      [&](const JobControl& control) { evaluate_labelling(project, folder.path() / "labels", 2, control); },
      3, random);
  check_moments(
      [&](const JobControl& control) {
        evaluate_landmarks(project, folder.path() / "landmarks", 2, control);
      },
      4, random);
  check_moments(
      [&](const JobControl& control) { export_project(project, folder.path() / "out", {}, control); }, 3,
      random);
}

TEST_CASE("jobs of the window stop within a second") {
  Collection chairs(16, 150);
  chairs.imported();
  const std::vector<std::pair<const char*, std::function<void(Project&, const JobControl&)>>> works{
      {"suggest",
       [](Project& project, const JobControl& control) { suggest_templates(project, {}, 2, control); }},
      {"learn",
       [](Project& project, const JobControl& control) {
         learn_templates(project, {chair_template()}, {}, few_shapes(), 1, true, 2, control);
       }},
      {"fit", [](Project& project, const JobControl& control) {
         project.clear_fits();
         fit_collection(project, {chair_template()}, {}, 2, control);
       }}};
  for (const auto& each : works) {
    for (int i = 0; i < 2; ++i) {
      CAPTURE(each.first);
      Jobs jobs;
      const JobId id = jobs.start(each.first, [&](const JobControl& control) -> Jobs::Apply {
        Project project = Project::open(chairs.path);
        each.second(project, control);
        return {};
      });
      std::this_thread::sleep_for(std::chrono::milliseconds(5 + chairs.random.below(200)));
      const Moment told;
      jobs.cancel(id);
      while (!jobs.idle() && Clock::now() - told.time < std::chrono::seconds(30)) {
        jobs.poll();
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
      CHECK(jobs.idle());
      CHECK(seconds_between(told, Moment()) < longest);
    }
  }
}
