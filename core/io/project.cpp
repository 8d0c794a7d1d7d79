// Creating and opening project files, transactions, refused inputs and settings.
#include "core/io/project.h"

#include <unistd.h>

#include "core/base/error.h"
#include "core/io/project_connection.h"
#include "core/io/project_schema.h"

namespace archetype {

namespace fs = std::filesystem;

namespace {

void prepare_connection(Database& database) {
  // FULL: a commit has reached the disk when it returns, so that even a power cut loses nothing of it.
  database.execute("PRAGMA synchronous = FULL");
  database.execute("PRAGMA foreign_keys = ON");
  database.execute("PRAGMA cell_size_check = ON");
}

// A write-ahead log: who reads does not stop who writes. Another program may come in the moment after the
// file was made.
void use_log(Database& database) {
  database.execute_in_turn("PRAGMA journal_mode = WAL");
}

// True for what a program killed while it created the file has left.
bool is_blank(Database& database) {
  return database.number("PRAGMA application_id") == 0 && database.number("PRAGMA user_version") == 0 &&
         database.number("SELECT count(*) FROM sqlite_schema") == 0;
}

void make_project(Database& database) {
  // The tables first, in one transaction of the rollback journal: the file is blank or whole at any moment.
  create_schema(database);
  if (!database.path().empty()) use_log(database);
}

bool may_write(const fs::path& path) {
  return ::access(path.c_str(), W_OK) == 0;
}

// A program that ended without closing the project, or has it open, left its newest commits in the log beside
// it.
bool has_log(const fs::path& path) {
  std::error_code none;
  const std::uintmax_t log = fs::file_size(path.string() + "-wal", none);
  return !none && log > 0;
}

// On a medium or in a folder where nothing can be written, a project can still be read if it has no log.
Database::Mode mode_for(const fs::path& path) {
  if (may_write(path) && may_write(path.parent_path())) return Database::Mode::open;
  return has_log(path) ? Database::Mode::open : Database::Mode::read;
}

std::unique_ptr<Database> open_database(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) {
    throw FileError(path, "does not exist; check the name, or make a project with `archetype import`");
  }
  if (!fs::is_regular_file(status)) throw FileError(path, "is not a file; give the path of a project");
  return std::make_unique<Database>(path, mode_for(path));
}

}  // namespace

std::string_view to_string(FitStatus status) {
  switch (status) {
    case FitStatus::learned:
      return "learned";
    case FitStatus::outlier:
      return "outlier";
    case FitStatus::fitted:
      break;
  }
  return "fitted";
}

Project::Project(std::unique_ptr<Connection> connection) : connection_(std::move(connection)) {
  prepare_connection(*connection_->database);
}
Project::Project(Project&&) noexcept = default;
Project& Project::operator=(Project&&) noexcept = default;
Project::~Project() = default;

Project Project::create(const fs::path& path) {
  const fs::path absolute = fs::absolute(path);
  std::error_code error;
  if (fs::exists(fs::symlink_status(absolute, error))) {
    throw FileError(absolute, "exists already; choose another name");
  }
  auto connection = std::make_unique<Connection>();
  connection->database = std::make_unique<Database>(absolute, Database::Mode::create);
  make_project(*connection->database);
  return Project(std::move(connection));
}

Project Project::open(const fs::path& path) {
  auto connection = std::make_unique<Connection>();
  const fs::path absolute = fs::absolute(path);
  try {
    connection->database = open_database(absolute);
    check_and_migrate_schema(*connection->database);
    if (connection->database->writable()) use_log(*connection->database);
  } catch (const DiskFull&) {
    // The log itself has no room.
    connection->database.reset();
    if (has_log(absolute)) throw;
    connection->database = std::make_unique<Database>(absolute, Database::Mode::read_full);
    check_and_migrate_schema(*connection->database);
  }
  return Project(std::move(connection));
}

Project Project::open_or_create(const fs::path& path) {
  std::error_code error;
  if (!fs::exists(path, error)) return create(path);
  {
    const auto database = open_database(fs::absolute(path));
    if (is_blank(*database)) make_project(*database);
  }
  return open(path);
}

Project Project::in_memory() {
  auto connection = std::make_unique<Connection>();
  connection->database = std::make_unique<Database>(fs::path(), Database::Mode::memory);
  make_project(*connection->database);
  return Project(std::move(connection));
}

const fs::path& Project::path() const {
  return connection_->database->path();
}

void Project::copy_to(const fs::path& path) const {
  const fs::path absolute = fs::absolute(path);
  std::error_code error;
  if (fs::exists(fs::symlink_status(absolute, error))) {
    throw FileError(absolute, "exists already; choose another name");
  }
  Statement(*connection_->database, "VACUUM INTO ?").bind(std::string_view(absolute.native())).run();
}

Project::Transaction::Transaction(Project& project)
    : scope_(std::make_unique<WriteScope>(*project.connection_->database)) {}
Project::Transaction::~Transaction() = default;
void Project::Transaction::commit() {
  scope_->commit();
}

void Project::set_refused(const std::vector<RefusedInput>& refused) {
  WriteScope scope(*connection_->database);
  Statement insert(*connection_->database, "INSERT OR REPLACE INTO refused (path, reason) VALUES (?, ?)");
  for (const RefusedInput& input : refused) {
    insert.bind(std::as_bytes(std::span(input.path.native()))).bind(std::string_view(input.reason)).run();
  }
  scope.commit();
}

void Project::forget_refused(const std::vector<fs::path>& paths) {
  WriteScope scope(*connection_->database);
  Statement remove(*connection_->database, "DELETE FROM refused WHERE path = ?");
  for (const fs::path& path : paths) remove.bind(std::as_bytes(std::span(path.native()))).run();
  scope.commit();
}

std::vector<RefusedInput> Project::refused() const {
  Statement rows(*connection_->database, "SELECT path, reason FROM refused ORDER BY path");
  std::vector<RefusedInput> refused;
  while (rows.step()) refused.push_back({rows.text(0), rows.text(1)});
  return refused;
}

void Project::set_setting(const std::string& key, const std::string& value) {
  WriteScope scope(*connection_->database);
  Statement(*connection_->database, "INSERT OR REPLACE INTO settings (key, value) VALUES (?, ?)")
      .bind(std::string_view(key))
      .bind(std::string_view(value))
      .run();
  scope.commit();
}

std::optional<std::string> Project::setting(const std::string& key) const {
  Statement row(*connection_->database, "SELECT value FROM settings WHERE key = ?");
  row.bind(std::string_view(key));
  if (!row.step()) return std::nullopt;
  return row.text(0);
}

}  // namespace archetype
