// The furniture of Debian's package sweethome3d-furniture: zip archives of OBJ files, each with a catalogue
// that names what there is, its maker and its licence.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/job_control.h"

namespace archetype {

struct FurniturePiece {
  std::string id;     // "Scopia#chair3"
  std::string title;  // "Oak chair"
  std::string tags;   // "Dining, Chair, Seat"
  std::string creator;
  std::string licence;                                        // that of the catalogue
  std::string source;                                         // the catalogue's own name
  std::string model;                                          // the OBJ inside the archive
  std::array<double, 9> rotation{1, 0, 0, 0, 1, 0, 0, 0, 1};  // by rows: turns the model upright
};

// Parses a PluginFurnitureCatalog.properties (Java's format: Latin-1, \u escapes). Pieces without a model are
// left out. Throws InputError for a rotation that is none; `name` is only used in its message.
std::vector<FurniturePiece> parse_furniture_catalog(std::string_view text, const std::filesystem::path& name);

// Chairs, stools, benches, sofas and the like: what people sit on.
bool is_seat(const FurniturePiece& piece);

// Who made a shape, and under which licence it is passed on.
struct Credit {
  std::string shape;  // its name in the collection
  std::string title;
  std::string creator;
  std::string licence;
  std::string source;
  friend bool operator==(const Credit&, const Credit&) = default;
};

inline constexpr const char* furniture_folder = "/usr/share/sweethome3d/furniture";

// Writes the seats of all archives in `furniture` to `target` as OBJ files, upright and with their credit in
// the first lines, and a credits.json beside them. What an earlier call left finished is kept. The names of
// files are made here; nothing of the archives decides where something is written. Throws FileError if the
// package is not installed. False when cancelled.
bool extract_seats(const std::filesystem::path& furniture, const std::filesystem::path& target,
                   const JobControl& control);

// Those of a folder that extract_seats filled; none for any other folder. Throws InputError.
std::vector<Credit> read_credits(const std::filesystem::path& folder);

}  // namespace archetype
