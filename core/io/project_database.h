// SQLite behind two small types. Only project*.cpp include this.
#pragma once

#include <concepts>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"

struct sqlite3;
struct sqlite3_stmt;

namespace archetype {

class DiskFull : public FileError {
 public:
  explicit DiskFull(const std::filesystem::path& file);
};

// One connection, set up for files that may come from a stranger: no triggers, no views, bounded values.
// Every failure is a FileError that says what to do.
class Database {
 public:
  // read: nothing is written, not even beside the file; for a place where that is not allowed.
  // read_full: the same where the reason is a full disk.
  enum class Mode { open, create, memory, read, read_full };
  Database(const std::filesystem::path& path, Mode mode);
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;
  ~Database();

  void execute(const std::string& sql);
  // Also where SQLite refuses at once instead of waiting: so it does where two connections would wait for
  // each other, as with two that change the journal. Then it tries again, for as long as execute() waits.
  void execute_in_turn(const std::string& sql);
  std::int64_t number(const std::string& sql);  // the first column of the only row, a PRAGMA's value for one
  std::int64_t last_row_id() const;
  bool in_transaction() const;
  bool writable() const;
  const std::filesystem::path& path() const { return path_; }

  // Throws for the error that SQLite has just met.
  [[noreturn]] void fail(const std::string& doing) const;
  // Throws for content that no Archetype wrote.
  [[noreturn]] void fail_damaged(const std::string& what) const;

 private:
  friend class Statement;
  std::filesystem::path path_;
  bool disk_full_ = false;
  sqlite3* handle_ = nullptr;
};

// A prepared statement; bind() in the order of the question marks, then step() through the rows.
class Statement {
 public:
  Statement(Database& database, std::string_view sql);
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;
  ~Statement();

  Statement& bind(std::integral auto value) { return bind_integer(static_cast<std::int64_t>(value)); }
  Statement& bind(double value);
  Statement& bind(std::string_view text);
  Statement& bind(std::span<const std::byte> blob);
  Statement& bind_null();

  bool step();  // whether there is a row
  void run();   // for statements without rows; may be bound and run again after

  bool is_null(int column) const;
  std::int64_t integer(int column) const;
  double real(int column) const;
  std::string text(int column) const;
  std::vector<std::byte> blob(int column) const;

 private:
  Statement& bind_integer(std::int64_t value);
  void check(int code);
  Database& database_;
  sqlite3_stmt* handle_ = nullptr;
  int bound_ = 0;
};

// Makes several writes one: joins the transaction that is open, or opens one and rolls it back unless
// committed.
class WriteScope {
 public:
  explicit WriteScope(Database& database);
  WriteScope(const WriteScope&) = delete;
  WriteScope& operator=(const WriteScope&) = delete;
  ~WriteScope();
  void commit();

 private:
  Database& database_;
  bool owner_;
};

}  // namespace archetype
