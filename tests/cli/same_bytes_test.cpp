// The same inputs give the same bytes, whatever the number of threads, the order of arguments and what
// happened on the way.
#include <doctest/doctest.h>

#include <algorithm>
#include <csignal>

#include "core/base/random.h"
#include "core/io/project.h"
#include "core/io/template_file.h"
#include "tests/cli/program.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/small_collection.h"

using namespace archetype;
using namespace archetype::test;

namespace fs = std::filesystem;

namespace {

using Files = std::map<std::string, std::string>;

// Chairs, a file that cannot be read, a template, and the commands that are run on them.
class Work {
 public:
  explicit Work(std::size_t count) {
    write_chairs(folder_.path(), count);
    folder_.write("shapes/bad.off", "OFF\n9 9\n");
    write_template(folder_.path() / "chair.json", chair_template());
  }
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
  std::vector<std::string> shape_files() const {
    std::vector<std::string> files;
    for (const auto& entry : fs::directory_iterator(folder_.path() / "shapes")) files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
  }
  std::vector<std::string> import_arguments(const std::string& project) const {
    return {"import", path(project), path("shapes"), "--points", "60"};
  }
  std::vector<std::string> fit_arguments(const std::string& project) const {
    return {"fit", path(project), "--template", path("chair.json")};
  }
  std::vector<std::string> learn_arguments(const std::string& project) const {
    return {"learn", path(project), "--template", path("chair.json")};
  }
  Files exported(const std::string& project) const {
    const std::string out = path(project + ".export");
    require_run({"export", path(project), "--out", out});
    return folder_content(out);
  }
  // What a run without any disturbance exports.
  Files undisturbed(const std::string& project) const {
    require_run(import_arguments(project), 3);
    require_run(fit_arguments(project));
    return exported(project);
  }

 private:
  ScratchFolder folder_;
};

// Opens the project, if there is one yet, reads every row of it, and counts them.
struct Committed {
  std::size_t shapes = 0;
  std::size_t fits = 0;

  explicit Committed(const fs::path& path) {
    if (!fs::exists(path)) return;
    const Project project = Project::open_or_create(path);
    for (const ShapeRecord& shape : project.shapes()) {
      CHECK(project.samples(shape.id).size() == 60);
      ++shapes;
      if (!project.fit(shape.id)) continue;
      CHECK(project.labels(shape.id)->size() == shape.element_count);
      ++fits;
    }
  }
};

constexpr int kills = 25;
constexpr std::size_t shape_count = 48;
constexpr int longest_delay = 500;  // milliseconds; nearly as long as an undisturbed run

std::optional<Signal> kill_within(RandomStream& random) {
  return Signal{SIGKILL, std::chrono::milliseconds(random.below(longest_delay)), {}};
}

}  // namespace

TEST_CASE("threads and the order of arguments do not matter") {
  const Work work(12);
  const Files expected = work.undisturbed("p");
  CHECK(expected.size() == 12 + 12 + 5);
  std::vector<std::string> files = work.shape_files();
  for (const char* threads : {"1", "2", "8"}) {
    const std::string project = std::string("p") + threads;
    std::rotate(files.begin(), files.begin() + 5, files.end());
    std::swap(files[0], files[3]);
    std::vector<std::string> import{"import", work.path(project), "--points", "60", "--threads", threads};
    import.insert(import.end(), files.begin(), files.end());
    require_run(import, 3);
    std::vector<std::string> fit = work.fit_arguments(project);
    fit.insert(fit.end(), {"--threads", threads});
    require_run(fit);
    CHECK((work.exported(project) == expected));
  }
}

TEST_CASE(
    "an import that is killed 25 times loses nothing that it committed, and ends as if it had not been") {
  const Work work(shape_count);
  const Files expected = work.undisturbed("whole");
  RandomStream random(1);
  std::size_t before = 0;
  for (int killed = 0; killed < kills;) {
    const bool was_killed = run_archetype(work.import_arguments("p"), kill_within(random)).exit_code == -1;
    const Committed now(work.path("p"));
    CHECK(now.shapes >= before);
    before = now.shapes;
    if (was_killed) ++killed;
    if (!was_killed || before == shape_count) {  // it came through: from the start
      for (const char* ending : {"p", "p-wal", "p-shm"}) fs::remove(work.path(ending));
      before = 0;
    }
  }
  CHECK((work.undisturbed("p") == expected));
}

TEST_CASE("a fit that is killed 25 times loses nothing that it committed, and ends as if it had not been") {
  const Work work(shape_count);
  const Files expected = work.undisturbed("whole");
  require_run(work.import_arguments("p"), 3);
  RandomStream random(2);
  std::size_t before = 0;
  for (int killed = 0; killed < kills;) {
    const bool was_killed = run_archetype(work.fit_arguments("p"), kill_within(random)).exit_code == -1;
    const Committed now(work.path("p"));
    CHECK(now.shapes == shape_count);
    CHECK(now.fits >= before);
    before = now.fits;
    if (was_killed) ++killed;
    if (!was_killed) {
      Project::open(work.path("p")).clear_fits();
      before = 0;
    }
  }
  CHECK((work.undisturbed("p") == expected));
}

namespace {

// Learning, killed at random moments of the whole that it takes, and gone on with after each.
void check_killed_learning(const Work& work, const std::vector<std::string>& learn, std::size_t shapes,
                           std::uint64_t seed) {
  const auto begin_anew = [&] {
    for (const char* ending : {"p", "p-wal", "p-shm"}) fs::remove(work.path(ending));
    require_run(work.import_arguments("p"), 3);
  };
  begin_anew();
  const Finished undisturbed = run_archetype(learn);
  REQUIRE(undisturbed.exit_code == 0);
  const Files expected = work.exported("p");
  const auto whole = static_cast<std::uint64_t>(1000 * undisturbed.seconds_after_signal);
  RandomStream random(seed);
  begin_anew();
  for (int killed = 0; killed < 20;) {
    const Signal kill{SIGKILL, std::chrono::milliseconds(random.below(whole)), {}};
    const Finished run = run_archetype(learn, kill);
    CHECK(Committed(work.path("p")).shapes == shapes);
    if (run.exit_code == -1) {
      ++killed;
    } else {
      REQUIRE(run.exit_code == 0);
      CHECK((work.exported("p") == expected));
      begin_anew();
    }
  }
  require_run(learn);
  CHECK((work.exported("p") == expected));
}

}  // namespace

TEST_CASE("a learning that is killed 20 times at any moment ends as if it had not been") {
  const Work work(10);
  check_killed_learning(work, work.learn_arguments("p"), 10, 3);
}

TEST_CASE("a learning from nothing that is killed 20 times at any moment ends as if it had not been") {
  const Work work(4);
  check_killed_learning(work, {"learn", work.path("p"), "--threads", "2"}, 4, 4);
}
