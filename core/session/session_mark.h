// What a start of the program leaves behind while it runs, so that the next one can tell that it was killed,
// and what was open in it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/session/document.h"

namespace archetype {

// What was open.
struct SessionRecord {
  std::filesystem::path project;  // empty: none
  std::string title;              // for people
  std::filesystem::path
      folder;  // of the shapes of an untitled project; empty: the project has a file of its own
  friend bool operator==(const SessionRecord&, const SessionRecord&) = default;
};

// A session that runs. Its files are gone when it ends as it should; the lock on one of them ends with the
// process however that ends, so that no number of a process is ever mistaken for another one's.
class SessionMark {
 public:
  // Throws FileError where nothing can be written to the folder, which is made.
  explicit SessionMark(const std::filesystem::path& folder);
  SessionMark(const SessionMark&) = delete;
  SessionMark& operator=(const SessionMark&) = delete;
  ~SessionMark();

  // What is open now, which last_opened() tells the next start of. Throws FileError.
  void record(const SessionRecord& open) const;
  // For the text of the document (document_text.h) while no project holds it.
  const std::filesystem::path& document() const { return document_; }

 private:
  std::filesystem::path lock_, record_, document_;
  int descriptor_ = -1;
};

// What any session of the folder opened last, however it ended; nothing where that is not known.
std::optional<SessionRecord> last_opened(const std::filesystem::path& folder);

// One that ended without taking its files away.
struct LostSession {
  SessionRecord record;
  std::optional<Document> document;  // that no project held
  std::string when;                  // the last sign of it, in local time: "2026-11-26 14:05"
  std::vector<std::filesystem::path> files;
};

// Those of the folder, newest first; what cannot be read is left out. At most 20.
std::vector<LostSession> lost_sessions(const std::filesystem::path& folder);
// Takes its files away.
void forget_session(const LostSession& session);

}  // namespace archetype
