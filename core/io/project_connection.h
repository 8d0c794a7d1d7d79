// What the project*.cpp files share.
#pragma once

#include "core/io/project.h"
#include "core/io/project_blobs.h"
#include "core/io/project_database.h"

namespace archetype {

struct Project::Connection {
  std::unique_ptr<Database> database;
};

// A column that counts something.
inline std::size_t count_column(Database& database, const Statement& row, int column) {
  const std::int64_t value = row.integer(column);
  if (value < 0 || value > std::int64_t{UINT32_MAX}) {
    database.fail_damaged("it counts " + std::to_string(value));
  }
  return static_cast<std::size_t>(value);
}

// Runs a decoder; `what` names the blob for the error.
template <class Decode>
auto decode_for(Database& database, const std::string& what, Decode decode) {
  try {
    return decode();
  } catch (const BadBlob& error) {
    database.fail_damaged(what + ": " + error.what());
  }
}

}  // namespace archetype
