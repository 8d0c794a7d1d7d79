// What a session leaves when it is killed, and that one that runs or ended is never taken for it.
#include "core/session/session_mark.h"

#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <iterator>

#include "core/io/file.h"
#include "core/session/document_text.h"
#include "tests/support/scratch_folder.h"

using namespace archetype;
using archetype::test::ScratchFolder;

namespace {

namespace fs = std::filesystem;

Document one_template() {
  PartTemplate part_template;
  part_template.name = "stool";
  part_template.parts.resize(3);
  return {{std::make_shared<const PartTemplate>(part_template)}, 0};
}

// A process that has begun a session, written its record and document, and was killed.
void leave_killed(const fs::path& folder, const SessionRecord& record, const std::string& document) {
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    const SessionMark mark(folder);
    mark.record(record);
    if (!document.empty()) replace_file(mark.document(), document);
    ::kill(::getpid(), SIGKILL);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  REQUIRE(WIFSIGNALED(status));
}

std::ptrdiff_t files_in(const fs::path& folder) {
  return std::distance(fs::directory_iterator(folder), {});
}

}  // namespace

TEST_CASE("A session that runs, or has ended, is not lost") {
  const ScratchFolder scratch;
  const fs::path folder = scratch.path() / "data" / "sessions";
  CHECK(lost_sessions(folder).empty());
  {
    const SessionMark mark(folder);
    const SessionMark other(folder);
    mark.record({scratch.write("p.archetype", "x"), "p", {}});
    CHECK(mark.document() != other.document());
    CHECK(lost_sessions(folder).empty());
  }
  CHECK(files_in(folder) == 1);  // that of last_opened()
}

TEST_CASE(
    "What was opened last is known after the session has ended, and nothing of it if it was not written") {
  const ScratchFolder scratch;
  const fs::path folder = scratch.path() / "sessions";
  CHECK_FALSE(last_opened(folder));
  const SessionRecord first{scratch.write("a.archetype", "x"), "a", {}};
  const SessionRecord second{scratch.write("b.archetype", "x"), "chairs", scratch.path()};
  {
    const SessionMark mark(folder);
    CHECK_FALSE(last_opened(folder));
    mark.record(first);
    mark.record(second);
    CHECK(last_opened(folder) == second);
  }
  CHECK(last_opened(folder) == second);
  for (const char* text : {"", "{", "[]", R"({"project": 5})", R"({"title": "chairs"})"}) {
    replace_file(folder / "last.json", text);
    CHECK_FALSE(last_opened(folder));
  }
}

TEST_CASE("A session that was killed says what was open, until it is forgotten") {
  const ScratchFolder scratch;
  const fs::path folder = scratch.path() / "sessions";
  const SessionRecord record{scratch.write("p.archetype", "x"), "chairs", "/shapes/chairs"};
  leave_killed(folder, record, "");
  leave_killed(folder, {}, format_document(one_template()));
  const std::vector<LostSession> lost = lost_sessions(folder);
  REQUIRE(lost.size() == 2);
  const LostSession& with_project = lost[0].document ? lost[1] : lost[0];
  const LostSession& with_document = lost[0].document ? lost[0] : lost[1];
  CHECK(with_project.record == record);
  CHECK(with_project.when.size() == 16);
  CHECK(with_document.document.value() == one_template());
  CHECK(lost_sessions(folder).size() == 2);
  for (const LostSession& each : lost) forget_session(each);
  CHECK(files_in(folder) == 1);  // that of last_opened()
}

TEST_CASE("Lost sessions come newest first, with the time of their last sign") {
  const ScratchFolder scratch;
  const fs::path folder = scratch.path() / "sessions";
  for (int i = 0; i < 3; ++i) leave_killed(folder, {}, format_document(one_template()));
  using Days = std::chrono::duration<int, std::ratio<86400>>;
  std::vector<LostSession> lost = lost_sessions(folder);
  REQUIRE(lost.size() == 3);
  for (int i = 0; i < 3; ++i)
    for (const fs::path& file : lost[static_cast<std::size_t>(i)].files)
      if (fs::exists(file))
        fs::last_write_time(file, fs::file_time_type::clock::now() - Days(400 * ((i + 1) % 3)));
  const std::vector<fs::path> newest = lost[2].files;
  lost = lost_sessions(folder);
  CHECK(lost[0].files == newest);
  CHECK(lost[0].when > lost[1].when);
  CHECK(lost[1].when > lost[2].when);
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  REQUIRE(::localtime_r(&now, &parts));
  const int year = 1900 + parts.tm_year;
  CHECK(std::abs(std::stoi(lost[0].when.substr(0, 4)) - year) <= 1);
}

TEST_CASE("What a killed session left that leads nowhere, or is broken, is taken away") {
  const ScratchFolder scratch;
  const fs::path folder = scratch.path() / "sessions";
  leave_killed(folder, {"/nowhere/gone.archetype", "gone", {}}, "");
  leave_killed(folder, {}, "{\"format\": \"archetype-document\", \"templates\"");
  leave_killed(folder, {}, format_document({}));
  CHECK(lost_sessions(folder).empty());
  CHECK(files_in(folder) == 1);  // that of last_opened()
  leave_killed(folder, {scratch.write("p.archetype", "x"), "chairs", {}}, "");
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".json")
      scratch.write("sessions/" + entry.path().filename().string(), "[1,");
  CHECK(lost_sessions(folder).empty());
}
