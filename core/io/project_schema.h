// The tables of a project file and how older ones become newer ones.
#pragma once

#include "core/io/project_database.h"

namespace archetype {

// Tells an Archetype project from other SQLite files: "Arch" in ASCII.
inline constexpr std::int64_t project_application_id = 0x41726368;

std::int64_t newest_project_version();

// Makes the tables in an empty database. All or nothing, also if the program is killed half-way.
void create_schema(Database& database);

// Throws FileError for an SQLite file of another program and for a project of a newer version; migrates older
// ones. One that cannot be written is read as it is: what newer versions added is not there.
void check_and_migrate_schema(Database& database);

}  // namespace archetype
