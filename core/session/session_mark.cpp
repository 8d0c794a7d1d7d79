#include "core/session/session_mark.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <ctime>
#include <nlohmann/json.hpp>
#include <system_error>

#include "core/base/error.h"
#include "core/io/file.h"
#include "core/io/json_input.h"
#include "core/session/document_text.h"

namespace archetype {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using FileTime = fs::file_time_type;

constexpr const char* lock_ending = ".lock";
constexpr const char* record_ending = ".json";
constexpr const char* document_ending = ".document";
constexpr const char* last_name = "last.json";
constexpr std::size_t most_lost = 20;

// Negative where it is locked by a session that runs, or cannot be opened.
int open_locked(const fs::path& path, int flags) {
  const int descriptor = ::open(path.c_str(), O_RDWR | O_CLOEXEC | flags, 0666);
  if (descriptor < 0) return descriptor;
  if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0) return descriptor;
  const int reason = errno;
  ::close(descriptor);
  errno = reason;
  return -1;
}

bool is_abandoned(const fs::path& lock) {
  const int descriptor = open_locked(lock, 0);
  if (descriptor < 0) return false;
  ::close(descriptor);
  return true;
}

std::string local_time(FileTime time) {
  const std::time_t seconds =
      std::chrono::system_clock::to_time_t(std::chrono::time_point_cast<std::chrono::system_clock::duration>(
          std::chrono::file_clock::to_sys(time)));
  std::tm parts{};
  if (!::localtime_r(&seconds, &parts)) return "";
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M", &parts);
  return text.data();
}

SessionRecord read_record(const fs::path& path) {
  constexpr std::uint64_t most_bytes = 1 << 16;
  const Json json = parse_json(read_file(path, most_bytes), path);
  const auto text = [&](const char* name) {
    const auto found = json.is_object() ? json.find(name) : json.end();
    return json.is_object() && found != json.end() && found->is_string() ? found->get<std::string>() : "";
  };
  return {text("project"), text("title"), text("folder")};
}

std::optional<Document> read_lost_document(const fs::path& path) {
  constexpr std::uint64_t most_bytes = std::uint64_t{64} << 20;
  std::error_code none;
  if (!fs::exists(path, none)) return std::nullopt;
  try {
    Document document = parse_document(read_file(path, most_bytes), path);
    if (document.templates.empty()) return std::nullopt;
    return document;
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

// Nothing if there was nothing in it that could be brought back.
std::optional<std::pair<FileTime, LostSession>> read_lost(const fs::path& lock) {
  const fs::path stem = lock.parent_path() / lock.stem();
  LostSession lost;
  lost.files = {lock, stem.string() + record_ending, stem.string() + document_ending};
  std::error_code none;
  try {
    if (fs::exists(lost.files[1], none)) lost.record = read_record(lost.files[1]);
  } catch (const std::exception&) {
    lost.record = {};  // cut off, or not ours
  }
  if (!lost.record.project.empty() && !fs::is_regular_file(lost.record.project, none)) lost.record = {};
  lost.document = read_lost_document(lost.files[2]);
  if (lost.record.project.empty() && !lost.document) {
    forget_session(lost);
    return std::nullopt;
  }
  FileTime newest = FileTime::min();  // FileTime{} may lie in the future: its epoch is the library's choice
  std::vector<fs::path> signs = lost.files;
  if (!lost.record.project.empty()) {
    signs.push_back(lost.record.project);
    signs.emplace_back(lost.record.project.string() + "-wal");
  }
  for (const fs::path& sign : signs) {
    std::error_code missing;
    const FileTime time = fs::last_write_time(sign, missing);
    if (!missing) newest = std::max(newest, time);
  }
  if (newest != FileTime::min()) lost.when = local_time(newest);
  return std::pair{newest, std::move(lost)};
}

}  // namespace

SessionMark::SessionMark(const fs::path& folder) {
  std::error_code failed;  // opening the file names the reason
  fs::create_directories(folder, failed);
  for (int attempt = 0; descriptor_ < 0; ++attempt) {
    const std::string stem = (folder / (std::to_string(::getpid()) + "-" + std::to_string(attempt))).string();
    lock_ = stem + lock_ending;
    record_ = stem + record_ending;
    document_ = stem + document_ending;
    descriptor_ = open_locked(lock_, O_CREAT | O_EXCL);
    if (descriptor_ < 0 && errno != EEXIST && errno != EWOULDBLOCK)
      throw FileError(lock_, "cannot be written (" + std::generic_category().message(errno) + ")");
  }
}

SessionMark::~SessionMark() {
  std::error_code none;
  for (const fs::path& file : {document_, record_, lock_}) fs::remove(file, none);
  ::close(descriptor_);
}

void SessionMark::record(const SessionRecord& open) const {
  const Json json = {
      {"project", open.project.string()}, {"title", open.title}, {"folder", open.folder.string()}};
  const std::string text = json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  replace_file(record_, text);
  replace_file(record_.parent_path() / last_name, text);
}

std::optional<SessionRecord> last_opened(const fs::path& folder) {
  std::error_code none;
  if (!fs::exists(folder / last_name, none)) return std::nullopt;
  try {
    SessionRecord last = read_record(folder / last_name);
    if (!last.project.empty()) return last;
  } catch (const std::exception&) {  // cut off, or not ours
  }
  return std::nullopt;
}

std::vector<LostSession> lost_sessions(const fs::path& folder) {
  std::vector<std::pair<FileTime, LostSession>> found;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none)) {
    if (entry.path().extension() != lock_ending || !is_abandoned(entry.path())) continue;
    if (auto lost = read_lost(entry.path())) found.push_back(std::move(*lost));
  }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<LostSession> lost;
  for (auto& [time, session] : found)
    if (lost.size() < most_lost) lost.push_back(std::move(session));
  return lost;
}

void forget_session(const LostSession& session) {
  std::error_code none;
  for (auto file = session.files.rbegin(); file != session.files.rend(); ++file) fs::remove(*file, none);
}

}  // namespace archetype
