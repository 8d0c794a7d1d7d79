// Opens SQLite databases defensively and turns its error codes into exceptions.
#include "core/io/project_database.h"

#include <sqlite3.h>

#include <cerrno>
#include <chrono>
#include <thread>

namespace archetype {

namespace {

constexpr int longest_value = 512 * 1024 * 1024;  // bytes; labels of 250 million faces
constexpr int wait_for_lock = 10'000;             // milliseconds

// `system` is the errno of what failed: on a full disk, SQLite's own code may be that of any file it wanted.
// Throws DiskFull, which has an advice of its own.
std::string advice(int code, int system, const std::filesystem::path& file) {
  if (system == ENOSPC || system == EDQUOT || system == EFBIG) throw DiskFull(file);
  if (code == SQLITE_IOERR_WRITE || code == SQLITE_IOERR_SHMSIZE)
    return "the disk is full, a limit is reached or it is broken; what was committed before is safe: free "
           "some space and "
           "try again";
  switch (code & 0xff) {
    case SQLITE_FULL:
      throw DiskFull(file);
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return "another program is writing to it; wait for that to end and try again";
    case SQLITE_NOTADB:
      return "is not an Archetype project (not an SQLite database); choose another file";
    case SQLITE_CORRUPT:
      return "is damaged (broken SQLite pages); restore it from a copy or import the shapes into a new "
             "project";
    case SQLITE_READONLY:
    case SQLITE_PERM:
      return "cannot be written; check the permissions of the file and of its folder";
    case SQLITE_CANTOPEN:
      return "cannot be opened; check that its folder exists and that you may write there";
    case SQLITE_IOERR:
      return "the disk could not be read or written; what was committed before is safe: check the disk";
    case SQLITE_TOOBIG:
      return "holds a value larger than any project has; restore it from a copy";
    default:
      return "";
  }
}

int flags_of(Database::Mode mode) {
  switch (mode) {
    case Database::Mode::read:
    case Database::Mode::read_full:
      return SQLITE_OPEN_READONLY | SQLITE_OPEN_URI;
    case Database::Mode::open:
      return SQLITE_OPEN_READWRITE;
    case Database::Mode::create:
    case Database::Mode::memory:
      break;
  }
  return SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
}

// A database with a write-ahead log wants files beside it even to be read, unless nobody can write to it.
std::string immutable_uri(const std::filesystem::path& path) {
  std::string uri = "file:";
  for (const char c : path.string())
    uri += c == '%' ? "%25" : c == '?' ? "%3f" : c == '#' ? "%23" : std::string(1, c);
  return uri + "?immutable=1";
}

}  // namespace

DiskFull::DiskFull(const std::filesystem::path& file)
    : FileError(file, "the disk is full; what was committed before is safe: free some space and try again") {}

Database::Database(const std::filesystem::path& path, Mode mode)
    : path_(path), disk_full_(mode == Mode::read_full) {
  const int flags = flags_of(mode) | SQLITE_OPEN_EXRESCODE;
  const bool reads = mode == Mode::read || mode == Mode::read_full;
  const std::string name = mode == Mode::memory ? ":memory:" : reads ? immutable_uri(path) : path.string();
  if (sqlite3_open_v2(name.c_str(), &handle_, flags, nullptr) != SQLITE_OK) {
    const int code = handle_ == nullptr ? SQLITE_NOMEM : sqlite3_extended_errcode(handle_);
    const int system = handle_ == nullptr ? 0 : sqlite3_system_errno(handle_);
    sqlite3_close_v2(handle_);
    const std::string known = advice(code, system, path_);
    throw FileError(path_, known.empty() ? sqlite3_errstr(code) : known);
  }
  sqlite3_busy_timeout(handle_, wait_for_lock);
  sqlite3_limit(handle_, SQLITE_LIMIT_LENGTH, longest_value);
  sqlite3_db_config(handle_, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(handle_, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(handle_, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
  sqlite3_db_config(handle_, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
}

Database::~Database() {
  sqlite3_close_v2(handle_);
}

void Database::execute(const std::string& sql) {
  if (sqlite3_exec(handle_, sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) fail("");
}

void Database::execute_in_turn(const std::string& sql) {
  using Clock = std::chrono::steady_clock;
  const auto last = Clock::now() + std::chrono::milliseconds(wait_for_lock);
  while (sqlite3_exec(handle_, sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) {
    const bool busy = (sqlite3_extended_errcode(handle_) & 0xff) == SQLITE_BUSY;
    if (!busy || Clock::now() > last) fail("");
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

std::int64_t Database::number(const std::string& sql) {
  Statement statement(*this, sql);
  return statement.step() ? statement.integer(0) : 0;
}

std::int64_t Database::last_row_id() const {
  return sqlite3_last_insert_rowid(handle_);
}

bool Database::writable() const {
  return sqlite3_db_readonly(handle_, "main") == 0;
}

bool Database::in_transaction() const {
  return sqlite3_get_autocommit(handle_) == 0;
}

void Database::fail(const std::string& doing) const {
  const int code = sqlite3_extended_errcode(handle_);
  if (disk_full_ && (code & 0xff) == SQLITE_READONLY) throw DiskFull(path_);
  const std::string known = advice(code, sqlite3_system_errno(handle_), path_);
  const std::string what = known.empty() ? "is no usable project (" + std::string(sqlite3_errmsg(handle_)) +
                                               "); restore it from a copy"
                                         : known;
  throw FileError(path_, doing.empty() ? what : doing + ": " + what);
}

void Database::fail_damaged(const std::string& what) const {
  throw FileError(path_, what + "; the file is damaged: restore it from a copy or import the shapes again");
}

Statement::Statement(Database& database, std::string_view sql) : database_(database) {
  check(sqlite3_prepare_v2(database.handle_, sql.data(), static_cast<int>(sql.size()), &handle_, nullptr));
}

Statement::~Statement() {
  sqlite3_finalize(handle_);
}

void Statement::check(int code) {
  if (code != SQLITE_OK) database_.fail("");
}

Statement& Statement::bind_integer(std::int64_t value) {
  check(sqlite3_bind_int64(handle_, ++bound_, value));
  return *this;
}

Statement& Statement::bind(double value) {
  check(sqlite3_bind_double(handle_, ++bound_, value));
  return *this;
}

Statement& Statement::bind(std::string_view text) {
  check(sqlite3_bind_text64(handle_, ++bound_, text.empty() ? "" : text.data(), text.size(), SQLITE_TRANSIENT,
                            SQLITE_UTF8));
  return *this;
}

Statement& Statement::bind(std::span<const std::byte> blob) {
  check(blob.empty() ? sqlite3_bind_zeroblob(handle_, ++bound_, 0)
                     : sqlite3_bind_blob64(handle_, ++bound_, blob.data(), blob.size(), SQLITE_TRANSIENT));
  return *this;
}

Statement& Statement::bind_null() {
  check(sqlite3_bind_null(handle_, ++bound_));
  return *this;
}

bool Statement::step() {
  const int code = sqlite3_step(handle_);
  if (code == SQLITE_ROW) return true;
  if (code != SQLITE_DONE) database_.fail("");
  return false;
}

void Statement::run() {
  while (step()) {
  }
  sqlite3_reset(handle_);
  bound_ = 0;
}

bool Statement::is_null(int column) const {
  return sqlite3_column_type(handle_, column) == SQLITE_NULL;
}

std::int64_t Statement::integer(int column) const {
  return sqlite3_column_int64(handle_, column);
}

double Statement::real(int column) const {
  return sqlite3_column_double(handle_, column);
}

std::string Statement::text(int column) const {
  const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(handle_, column));
  return text == nullptr ? std::string()
                         : std::string(text, static_cast<std::size_t>(sqlite3_column_bytes(handle_, column)));
}

std::vector<std::byte> Statement::blob(int column) const {
  const auto* bytes = static_cast<const std::byte*>(sqlite3_column_blob(handle_, column));
  return bytes == nullptr ? std::vector<std::byte>()
                          : std::vector<std::byte>(bytes, bytes + sqlite3_column_bytes(handle_, column));
}

WriteScope::WriteScope(Database& database) : database_(database), owner_(!database.in_transaction()) {
  if (owner_) database_.execute("BEGIN IMMEDIATE");
}

WriteScope::~WriteScope() {
  // SQLite may have rolled back by itself, on a full disk for one.
  if (!owner_ || !database_.in_transaction()) return;
  try {
    database_.execute("ROLLBACK");
  } catch (const FileError&) {
    // The connection is unusable; SQLite rolls back when the file is next opened.
  }
}

void WriteScope::commit() {
  if (!owner_) return;
  database_.execute("COMMIT");
  owner_ = false;
}

}  // namespace archetype
